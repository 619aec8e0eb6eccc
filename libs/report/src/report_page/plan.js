// The way and the map, seen from above.

function boundsOf(map) {
    const xs = data.tracks.flatMap((track) => track.x), ys = data.tracks.flatMap((track) => track.y);
    const known = (values) => values.filter((value) => value !== null);
    if (map) {
        xs.push(...boundsOfMap(map).x);
        ys.push(...boundsOfMap(map).y);
    }
    const pad = map ? 0 : 0.06;
    return {x: spanOf(known(xs), pad), y: spanOf(known(ys), pad)};
}

/** Draws tracks, and a map below them, with equal scales. */
class Plan extends PlanCanvas {
    constructor(canvas, {map = null, tracks, legend = null}) {
        super(canvas);
        Object.assign(this, {map, tracks, legend});
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
        const {x: [x0, x1], y: [y0, y1]} = this.bounds;
        const tall = Math.min(Math.max(inner * (y1 - y0) / (x1 - x0), 150), Math.min(520, 0.8 * inner));
        return this.place(this.bounds, {width, height: tall + top + bottom, left, top, inner, tall});
    }

    gridPx(at) {
        return Math.max(35, Math.min(70, at.tall / 3));
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
        const at = this.layout(), pen = this.begin(at);
        if (this.map) this.drawMap(pen, at);
        this.drawGrid(pen, at, this.map ? 'rgba(255,255,255,.25)' : gridColour);
        for (const track of this.tracks) this.drawTrack(pen, at, track);
        this.drawEnds(pen, at);
        if (t !== null) this.drawMoment(pen, at, t);
        pen.restore();
        pen.strokeStyle = axisColour;
        pen.lineWidth = 1;
        pen.strokeRect(at.left, at.top, at.inner, at.tall);
        this.drawLabels(pen, at);
        if (this.map) this.drawScale(pen, at);
    }

    drawMap(pen, at) {
        pen.imageSmoothingEnabled = this.map.cell * at.scale < 1;
        pen.imageSmoothingQuality = 'high';
        this.drawImage(pen, at, this.image, this.map, 'rgb(128,128,128)');
    }

    drawTrack(pen, at, track) {
        pen.strokeStyle = track.colour;
        pen.lineWidth = track.width;
        pen.setLineDash(track.dashed ? [7, 4] : []);
        this.drawLine(pen, at, track.x, track.y);
        pen.setLineDash([]);
    }

    drawEnds(pen, at) {
        const last = this.flow.x.length - 1;
        const [u0, v0, u1, v1] = [at.u(this.flow.x[0]), at.v(this.flow.y[0]), at.u(this.flow.x[last]), at.v(this.flow.y[last])];
        pen.lineWidth = 2;
        pen.fillStyle = '#fff';
        pen.strokeStyle = '#111';
        this.markEnds(pen, at, this.flow.x, this.flow.y, 5);
        pen.fill();
        pen.stroke();
        if (this.map) return;
        pen.fillStyle = '#111';
        pen.textAlign = u0 < at.left + at.inner / 2 ? 'left' : 'right';
        pen.fillText('start', u0 + (pen.textAlign === 'left' ? 10 : -10), Math.min(v0 + 17, at.top + at.tall - 4));
        pen.textAlign = u1 < at.left + at.inner / 2 ? 'left' : 'right';
        pen.fillText('end', u1 + (pen.textAlign === 'left' ? 10 : -10), Math.max(v1 - 9, at.top + 14));
    }

    drawContacts(pen, at, contacts) {
        for (const [x0, y0, x1, y1, causeColour] of contacts) {
            for (const [style, width] of [['#111', 5], [causeColour, 3]]) {
                pen.strokeStyle = style;
                pen.lineWidth = width;
                this.drawLine(pen, at, [x0, x1], [y0, y1]);
            }
        }
    }

    drawMoment(pen, at, t) {
        const i = nearest(this.flow.t, t), u = at.u(this.flow.x[i]), v = at.v(this.flow.y[i]);
        if (this.map && data.pictures.length) {
            const picture = data.pictures[nearestPicture(t)];
            pen.fillStyle = colour('orange');
            pen.strokeStyle = '#111';
            pen.lineWidth = 0.7;
            for (const [x, y] of picture.points) {
                pen.beginPath();
                pen.arc(at.u(x), at.v(y), 3, 0, 2 * Math.PI);
                pen.fill();
                pen.stroke();
            }
            this.drawContacts(pen, at, picture.contacts);
        }
        pen.save();
        pen.translate(u, v);
        pen.rotate(-this.flow.heading[i]);
        pen.beginPath();
        for (const [a, b] of [[14, 0], [-8, 8], [-4, 0], [-8, -8]]) pen.lineTo(a, b);
        pen.closePath();
        pen.fillStyle = colour('blue');
        pen.strokeStyle = '#fff';
        pen.lineWidth = 2;
        pen.stroke();
        pen.fill();
        pen.restore();
        this.canvas.dataset.robot = `${u.toFixed(1)},${v.toFixed(1)}`;
        if (this.legend) this.legend(t);
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
