// Pictures seen from above, with equal scales: ways and maps.

const niceStep = (rough) => {
    const power = 10 ** Math.floor(Math.log10(rough));
    return power * [1, 2, 5, 10].find((digit) => digit * power >= rough * 0.999);
};

/** The lines of the two runs: B is thin, so that equal lines show as one. */
const looks = {
    truth: {name: 'ground truth', colour: data.colours.truth, width: 6},
    a: {name: 'A', colour: data.colours.a, width: 3.5},
    b: {name: 'B', colour: data.colours.b, width: 1.4},
};

function lineLegend(keys, more = []) {
    const line = (key) => {
        const mark = element('u', {});
        mark.style.borderTop = `${Math.max(looks[key].width, 2)}px solid ${looks[key].colour}`;
        return element('span', {}, mark, looks[key].name);
    };
    return element('div', {className: 'legend'}, ...keys.map(line), ...more);
}

/** What holds all ways, with some room. */
function boundsOfWays(ways) {
    const span = (values) => {
        const low = values.reduce((a, b) => Math.min(a, b)), high = values.reduce((a, b) => Math.max(a, b));
        const more = Math.max(0.06 * (high - low), (0.5 - high + low) / 2);
        return [low - more, high + more];
    };
    return {x: span(ways.flatMap((way) => way.x)), y: span(ways.flatMap((way) => way.y))};
}

/** What holds both. */
const together = (one, other) => ({x: [Math.min(one.x[0], other.x[0]), Math.max(one.x[1], other.x[1])],
    y: [Math.min(one.y[0], other.y[0]), Math.max(one.y[1], other.y[1])]});

const boundsOfMap = (maps) => ({x: [maps.x, maps.x + maps.columns * maps.cell], y: [maps.y, maps.y + maps.rows * maps.cell]});

/** A canvas with an image below and ways above; as high as one that shows `shape`, which has no axes. */
class Plan {
    constructor(canvas, {bounds, map = null, image = null, ways = {}, shape = null}) {
        Object.assign(this, {canvas, bounds, map, ways, shape: shape || bounds});
        if (map) {
            this.image = new Image();
            this.image.onload = () => {
                this.draw();
                canvas.dataset.complete = 'yes';
            };
            this.image.src = image;
        }
        this.draw();
    }

    layout() {
        const axes = this.image ? 0 : 1, width = this.canvas.parentElement.clientWidth;
        const left = 50 * axes + 1, top = 8 * axes + 1, inner = width - left - 8 * axes - 1;
        let [x0, x1] = this.bounds.x, [y0, y1] = this.bounds.y;
        const {x, y} = this.shape;
        const height = Math.min(Math.max(width * (y[1] - y[0]) / (x[1] - x[0]), 200), 420);
        const tall = height - top - 40 * axes - 1;
        const scale = Math.min(inner / (x1 - x0), tall / (y1 - y0));
        x0 = (x0 + x1 - inner / scale) / 2;
        y0 = (y0 + y1 - tall / scale) / 2;
        return {width, height, left, top, inner, tall, scale, x0, y0,
            u: (x) => left + (x - x0) * scale, v: (y) => top + tall - (y - y0) * scale};
    }

    draw() {
        const at = this.layout(), ratio = devicePixelRatio || 1, pen = this.canvas.getContext('2d');
        this.canvas.style.height = at.height + 'px';
        this.canvas.width = Math.round(at.width * ratio);
        this.canvas.height = Math.round(at.height * ratio);
        pen.scale(ratio, ratio);
        pen.font = '12px system-ui, "DejaVu Sans", sans-serif';
        pen.fillStyle = '#fff';
        pen.fillRect(0, 0, at.width, at.height);
        pen.save();
        pen.beginPath();
        pen.rect(at.left, at.top, at.inner, at.tall);
        pen.clip();
        if (this.image) this.drawImage(pen, at); else this.drawGrid(pen, at);
        for (const key of ['truth', 'a', 'b']) if (this.ways[key]) this.drawWay(pen, at, key);
        this.drawEnds(pen, at);
        if (this.image) this.drawScale(pen, at);
        pen.restore();
        pen.strokeStyle = '#777';
        pen.lineWidth = 1;
        pen.strokeRect(at.left, at.top, at.inner, at.tall);
        if (!this.image) this.drawLabels(pen, at);
    }

    drawImage(pen, at) {
        pen.fillStyle = 'rgb(205,205,205)';
        pen.fillRect(at.left, at.top, at.inner, at.tall);
        if (!this.image.complete) return;
        const {x: [x0, x1], y: [y0, y1]} = boundsOfMap(this.map);
        pen.imageSmoothingEnabled = false;
        pen.drawImage(this.image, at.u(x0), at.v(y1), (x1 - x0) * at.scale, (y1 - y0) * at.scale);
    }

    lines(at) {
        const step = niceStep(60 / at.scale);
        const ticks = (low, length) => {
            const result = [];
            for (let k = Math.ceil(low / step - 1e-9); k * step <= low + length + 1e-9; ++k) result.push(k * step);
            return result;
        };
        return {step, x: ticks(at.x0, at.inner / at.scale), y: ticks(at.y0, at.tall / at.scale)};
    }

    drawGrid(pen, at) {
        const {x, y} = this.lines(at);
        pen.strokeStyle = '#e4e4e4';
        pen.lineWidth = 1;
        pen.beginPath();
        for (const value of x) { pen.moveTo(at.u(value), at.top); pen.lineTo(at.u(value), at.top + at.tall); }
        for (const value of y) { pen.moveTo(at.left, at.v(value)); pen.lineTo(at.left + at.inner, at.v(value)); }
        pen.stroke();
    }

    drawLabels(pen, at) {
        const {step, x, y} = this.lines(at), digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
        const label = (value) => (value + 0 === 0 ? 0 : value).toFixed(digits);
        pen.fillStyle = '#222';
        pen.textAlign = 'center';
        for (const value of x) pen.fillText(label(value), at.u(value), at.top + at.tall + 15);
        pen.fillText('x, ahead of the start (m)', at.left + at.inner / 2, at.top + at.tall + 33);
        pen.textAlign = 'right';
        for (const value of y) pen.fillText(label(value), at.left - 6, at.v(value) + 4);
        pen.save();
        pen.translate(12, at.top + at.tall / 2);
        pen.rotate(-Math.PI / 2);
        pen.textAlign = 'center';
        pen.fillText('y, left (m)', 0, 0);
        pen.restore();
    }

    drawWay(pen, at, key) {
        const {x, y} = this.ways[key];
        pen.strokeStyle = looks[key].colour;
        pen.lineWidth = this.image ? 2 : looks[key].width;
        pen.lineJoin = 'round';
        pen.beginPath();
        x.forEach((value, i) => pen.lineTo(at.u(value), at.v(y[i])));
        pen.stroke();
    }

    /** A ring where each way starts, a square where it ends. */
    drawEnds(pen, at) {
        pen.lineWidth = 1.8;
        pen.fillStyle = '#fff';
        for (const key of ['a', 'b']) {
            const way = this.ways[key];
            if (!way) continue;
            const last = way.x.length - 1, size = key === 'a' ? 5 : 3;
            pen.strokeStyle = looks[key].colour;
            pen.beginPath();
            pen.arc(at.u(way.x[0]), at.v(way.y[0]), size, 0, 2 * Math.PI);
            pen.rect(at.u(way.x[last]) - size, at.v(way.y[last]) - size, 2 * size, 2 * size);
            if (key === 'a') pen.fill();
            pen.stroke();
        }
    }

    drawScale(pen, at) {
        const metres = niceStep(at.inner / at.scale / 6), length = metres * at.scale;
        const label = metres + ' m', width = pen.measureText(label).width;
        const left = at.left + at.inner - length - width - 24, top = at.top + at.tall - 28;
        pen.fillStyle = 'rgba(255,255,255,.85)';
        pen.fillRect(left, top, length + width + 18, 22);
        pen.fillStyle = '#111';
        pen.fillRect(left + 6, top + 9, length, 5);
        pen.textAlign = 'left';
        pen.fillText(label, left + length + 12, top + 15);
    }
}
