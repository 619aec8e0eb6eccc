// The way and the map, seen from above.

const niceStep = (rough) => {
    const power = 10 ** Math.floor(Math.log10(rough));
    return power * [1, 2, 5, 10].find((digit) => digit * power >= rough * 0.999);
};

function boundsOf(map) {
    const xs = data.tracks.flatMap((track) => track.x), ys = data.tracks.flatMap((track) => track.y);
    const known = (values) => values.filter((value) => value !== null);
    if (map) {
        xs.push(map.x, map.x + map.columns * map.cell);
        ys.push(map.y, map.y + map.rows * map.cell);
    }
    const span = (values, pad) => {
        const low = values.reduce((a, b) => Math.min(a, b)), high = values.reduce((a, b) => Math.max(a, b));
        const more = Math.max(pad * (high - low), (0.5 - high + low) / 2);
        return [low - more, high + more];
    };
    const pad = map ? 0 : 0.06;
    return {x: span(known(xs), pad), y: span(known(ys), pad)};
}

/** Draws tracks, and a map below them, with equal scales. */
class Plan {
    constructor(canvas, {map = null, tracks, legend = null}) {
        Object.assign(this, {canvas, map, tracks, legend});
        this.flow = data.tracks[data.tracks.length - 1];
        this.bounds = boundsOf(map);
        if (map) {
            this.image = new Image();
            this.image.onload = () => this.draw(now);
            this.image.src = map.png;
        }
        canvas.addEventListener('mousemove', (event) => hover(this.timeAt(event)));
        canvas.addEventListener('click', (event) => click(this.timeAt(event)));
        viewers.push((t) => this.draw(t));
        addEventListener('resize', () => this.draw(now));
    }

    /** Size of the canvas and where metres fall on it. */
    layout() {
        const width = this.canvas.parentElement.clientWidth;
        const left = 58, right = 14, top = 10, bottom = 46, inner = width - left - right;
        let [x0, x1] = this.bounds.x, [y0, y1] = this.bounds.y;
        const height = Math.min(Math.max(inner * (y1 - y0) / (x1 - x0), 150), Math.min(520, 0.8 * inner));
        const scale = Math.min(inner / (x1 - x0), height / (y1 - y0));
        x0 = (x0 + x1 - inner / scale) / 2;
        y0 = (y0 + y1 - height / scale) / 2;
        return {width, height: height + top + bottom, left, top, inner, tall: height, scale, x0, y0,
            u: (x) => left + (x - x0) * scale, v: (y) => top + height - (y - y0) * scale};
    }

    timeAt(event) {
        const box = this.canvas.getBoundingClientRect(), at = this.layout();
        const u = event.clientX - box.left, v = event.clientY - box.top;
        let best = 0, least = Infinity;
        this.flow.x.forEach((x, i) => {
            const distance = (at.u(x) - u) ** 2 + (at.v(this.flow.y[i]) - v) ** 2;
            if (distance < least) [best, least] = [i, distance];
        });
        return this.flow.t[best];
    }

    draw(t) {
        const at = this.layout(), ratio = devicePixelRatio || 1;
        this.canvas.style.height = at.height + 'px';
        this.canvas.width = Math.round(at.width * ratio);
        this.canvas.height = Math.round(at.height * ratio);
        const pen = this.canvas.getContext('2d');
        pen.scale(ratio, ratio);
        pen.fillStyle = '#fff';
        pen.fillRect(0, 0, at.width, at.height);
        pen.font = '12px system-ui, "DejaVu Sans", sans-serif';
        pen.save();
        pen.beginPath();
        pen.rect(at.left, at.top, at.inner, at.tall);
        pen.clip();
        this.drawGround(pen, at);
        this.drawGrid(pen, at);
        for (const track of this.tracks) this.drawTrack(pen, at, track);
        this.drawEnds(pen, at);
        if (t !== null) this.drawMoment(pen, at, t);
        pen.restore();
        this.drawAxes(pen, at);
        if (this.map) this.drawScale(pen, at);
    }

    drawGround(pen, at) {
        if (!this.map) return;
        pen.fillStyle = 'rgb(128,128,128)';
        pen.fillRect(at.left, at.top, at.inner, at.tall);
        if (!this.image.complete) return;
        pen.imageSmoothingEnabled = this.map.cell * at.scale < 1;
        pen.imageSmoothingQuality = 'high';
        const {x, y, columns, rows, cell} = this.map;
        pen.drawImage(this.image, at.u(x), at.v(y + rows * cell), columns * cell * at.scale, rows * cell * at.scale);
    }

    ticks(low, length, step) {
        const result = [];
        for (let k = Math.ceil(low / step - 1e-9); k * step <= low + length + 1e-9 * step; ++k) result.push(k * step);
        return result;
    }

    lines(at) {
        const step = niceStep(Math.max(35, Math.min(70, at.tall / 3)) / at.scale);
        return {step, x: this.ticks(at.x0, at.inner / at.scale, step), y: this.ticks(at.y0, at.tall / at.scale, step)};
    }

    drawGrid(pen, at) {
        const {x, y} = this.lines(at);
        pen.strokeStyle = this.map ? 'rgba(255,255,255,.25)' : '#e4e4e4';
        pen.lineWidth = 1;
        pen.beginPath();
        for (const value of x) { pen.moveTo(at.u(value), at.top); pen.lineTo(at.u(value), at.top + at.tall); }
        for (const value of y) { pen.moveTo(at.left, at.v(value)); pen.lineTo(at.left + at.inner, at.v(value)); }
        pen.stroke();
    }

    drawAxes(pen, at) {
        const {step, x, y} = this.lines(at), digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
        const bottom = at.top + at.tall, label = (value) => (value + 0 === 0 ? 0 : value).toFixed(digits);
        pen.strokeStyle = '#555';
        pen.strokeRect(at.left, at.top, at.inner, at.tall);
        pen.fillStyle = '#222';
        pen.textAlign = 'center';
        for (const value of x) pen.fillText(label(value), at.u(value), bottom + 16);
        pen.fillText('x, ahead of the start (m)', at.left + at.inner / 2, bottom + 36);
        pen.textAlign = 'right';
        for (const value of y) pen.fillText(label(value), at.left - 7, at.v(value) + 4);
        pen.textAlign = 'center';
        pen.translate(13, at.top + at.tall / 2);
        pen.rotate(-Math.PI / 2);
        pen.fillText(at.tall < 170 ? 'y, left (m)' : 'y, left of the start (m)', 0, 0);
        pen.setTransform(devicePixelRatio || 1, 0, 0, devicePixelRatio || 1, 0, 0);
    }

    drawTrack(pen, at, track) {
        pen.strokeStyle = track.colour;
        pen.lineWidth = track.width;
        pen.lineJoin = 'round';
        pen.setLineDash(track.dashed ? [7, 4] : []);
        pen.beginPath();
        let drawing = false;
        track.x.forEach((x, i) => {
            if (x === null) { drawing = false; return; }
            if (drawing) pen.lineTo(at.u(x), at.v(track.y[i])); else pen.moveTo(at.u(x), at.v(track.y[i]));
            drawing = true;
        });
        pen.stroke();
        pen.setLineDash([]);
    }

    drawEnds(pen, at) {
        const last = this.flow.x.length - 1;
        const [u0, v0, u1, v1] = [at.u(this.flow.x[0]), at.v(this.flow.y[0]), at.u(this.flow.x[last]), at.v(this.flow.y[last])];
        pen.lineWidth = 2;
        pen.fillStyle = '#fff';
        pen.strokeStyle = '#111';
        pen.beginPath();
        pen.arc(u0, v0, 5, 0, 2 * Math.PI);
        pen.rect(u1 - 5, v1 - 5, 10, 10);
        pen.fill();
        pen.stroke();
        if (this.map) return;
        pen.fillStyle = '#111';
        pen.textAlign = u0 < at.left + at.inner / 2 ? 'left' : 'right';
        pen.fillText('start', u0 + (pen.textAlign === 'left' ? 10 : -10), Math.min(v0 + 17, at.top + at.tall - 4));
        pen.textAlign = u1 < at.left + at.inner / 2 ? 'left' : 'right';
        pen.fillText('end', u1 + (pen.textAlign === 'left' ? 10 : -10), Math.max(v1 - 9, at.top + 14));
    }

    drawMoment(pen, at, t) {
        const i = nearest(this.flow.t, t), u = at.u(this.flow.x[i]), v = at.v(this.flow.y[i]);
        if (this.map && data.pictures.length) {
            pen.fillStyle = '#e69f00';
            pen.strokeStyle = '#111';
            pen.lineWidth = 0.7;
            for (const [x, y] of data.pictures[nearestPicture(t)].points) {
                pen.beginPath();
                pen.arc(at.u(x), at.v(y), 3, 0, 2 * Math.PI);
                pen.fill();
                pen.stroke();
            }
        }
        pen.save();
        pen.translate(u, v);
        pen.rotate(-this.flow.heading[i]);
        pen.beginPath();
        for (const [a, b] of [[14, 0], [-8, 8], [-4, 0], [-8, -8]]) pen.lineTo(a, b);
        pen.closePath();
        pen.fillStyle = '#0072b2';
        pen.strokeStyle = '#fff';
        pen.lineWidth = 2;
        pen.stroke();
        pen.fill();
        pen.restore();
        this.canvas.dataset.robot = `${u.toFixed(1)},${v.toFixed(1)}`;
        if (this.legend) this.legend(t);
    }

    drawScale(pen, at) {
        const metres = niceStep(at.inner / at.scale / 6), length = metres * at.scale;
        const label = metres + ' m', width = pen.measureText(label).width;
        const left = at.left + at.inner - length - width - 24, top = at.top + at.tall - 28;
        pen.fillStyle = 'rgba(255,255,255,.85)';
        pen.fillRect(left, top, length + width + 18, 22);
        pen.fillStyle = '#111';
        pen.fillRect(left + 6, top + 8, length, 6);
        pen.textAlign = 'left';
        pen.fillText(label, left + length + 12, top + 15);
    }
}

function addPlans() {
    const legend = element('div', {className: 'legend'});
    byId('way').before(legend);
    const describe = (t) => {
        legend.replaceChildren(...data.tracks.map((track) => {
            const i = nearest(track.t, t), line = element('u', {});
            line.style.borderTop = `${Math.min(track.width + 1, 5)}px ${track.dashed ? 'dashed' : 'solid'} ${track.colour}`;
            const where = element('b', {textContent: `x ${text(track.x[i])}, y ${text(track.y[i])}`});
            return element('span', {}, line, track.name, where);
        }), element('span', {className: 'unit', textContent: 'm'}));
    };
    new Plan(byId('way'), {tracks: data.tracks, legend: describe});
    const flow = data.tracks.filter((track) => track.name === 'flow');
    if (data.map) new Plan(byId('map'), {map: data.map, tracks: flow});
    else byId('map').parentElement.replaceWith(element('p', {textContent: 'Nothing was mapped.'}));
}
