// A drawing of the ground from above with equal scales: x to the right, y up, in metres.

/** 1, 2 or 5 times a power of ten, not below `rough`. */
const niceStep = (rough) => {
    const power = 10 ** Math.floor(Math.log10(rough));
    return power * [1, 2, 5, 10].find((digit) => digit * power >= rough * 0.999);
};

/** Lowest and highest value with a share of the span around them; at least 0.5 m apart. */
function spanOf(values, share) {
    const low = values.reduce((a, b) => Math.min(a, b)), high = values.reduce((a, b) => Math.max(a, b));
    const more = Math.max(share * (high - low), (0.5 - high + low) / 2);
    return [low - more, high + more];
}

const boundsOfMap = (map) => ({x: [map.x, map.x + map.columns * map.cell], y: [map.y, map.y + map.rows * map.cell]});

class PlanCanvas {
    constructor(canvas) {
        this.canvas = canvas;
    }

    /** Centres the bounds in an area of the canvas; u and v give the pixel of an x and of a y. */
    place({x: [x0, x1], y: [y0, y1]}, {width, height, left, top, inner, tall}) {
        const scale = Math.min(inner / (x1 - x0), tall / (y1 - y0));
        const low = {x: (x0 + x1 - inner / scale) / 2, y: (y0 + y1 - tall / scale) / 2};
        return {width, height, left, top, inner, tall, scale, x0: low.x, y0: low.y,
            u: (x) => left + (x - low.x) * scale, v: (y) => top + tall - (y - low.y) * scale};
    }

    /** Clears the canvas and clips to the area until pen.restore(). */
    begin(at) {
        const ratio = devicePixelRatio || 1, pen = this.canvas.getContext('2d');
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
        return pen;
    }

    drawImage(pen, at, image, map, ground) {
        pen.fillStyle = ground;
        pen.fillRect(at.left, at.top, at.inner, at.tall);
        if (!image.complete) return;
        const {x: [x0, x1], y: [y0, y1]} = boundsOfMap(map);
        pen.drawImage(image, at.u(x0), at.v(y1), (x1 - x0) * at.scale, (y1 - y0) * at.scale);
    }

    /** The least distance of the grid's lines, in pixels. */
    gridPx() {
        return 60;
    }

    lines(at) {
        const step = niceStep(this.gridPx(at) / at.scale);
        const ticks = (low, length) => {
            const result = [];
            for (let k = Math.ceil(low / step - 1e-9); k * step <= low + length + 1e-9 * step; ++k) result.push(k * step);
            return result;
        };
        return {step, x: ticks(at.x0, at.inner / at.scale), y: ticks(at.y0, at.tall / at.scale)};
    }

    drawGrid(pen, at, strokeStyle) {
        const {x, y} = this.lines(at);
        pen.strokeStyle = strokeStyle;
        pen.lineWidth = 1;
        pen.beginPath();
        for (const value of x) { pen.moveTo(at.u(value), at.top); pen.lineTo(at.u(value), at.top + at.tall); }
        for (const value of y) { pen.moveTo(at.left, at.v(value)); pen.lineTo(at.left + at.inner, at.v(value)); }
        pen.stroke();
    }

    drawLabels(pen, at) {
        const {step, x, y} = this.lines(at), digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
        const bottom = at.top + at.tall, label = (value) => (value + 0 === 0 ? 0 : value).toFixed(digits);
        pen.fillStyle = '#222';
        pen.textAlign = 'center';
        for (const value of x) pen.fillText(label(value), at.u(value), bottom + 16);
        pen.fillText('x, ahead of the start (m)', at.left + at.inner / 2, bottom + 35);
        pen.textAlign = 'right';
        for (const value of y) pen.fillText(label(value), at.left - 7, at.v(value) + 4);
        pen.save();
        pen.textAlign = 'center';
        pen.translate(13, at.top + at.tall / 2);
        pen.rotate(-Math.PI / 2);
        pen.fillText(at.tall < 170 ? 'y, left (m)' : 'y, left of the start (m)', 0, 0);
        pen.restore();
    }

    /** A line through the poses; null interrupts it. */
    drawLine(pen, at, xs, ys) {
        pen.lineJoin = 'round';
        pen.beginPath();
        let drawing = false;
        xs.forEach((x, i) => {
            if (x !== null) pen[drawing ? 'lineTo' : 'moveTo'](at.u(x), at.v(ys[i]));
            drawing = x !== null;
        });
        pen.stroke();
    }

    /** Begins a path with a ring at the start of a way and a square at its end, both `size` pixels about the middle. */
    markEnds(pen, at, xs, ys, size) {
        const last = xs.length - 1;
        pen.beginPath();
        pen.arc(at.u(xs[0]), at.v(ys[0]), size, 0, 2 * Math.PI);
        pen.rect(at.u(xs[last]) - size, at.v(ys[last]) - size, 2 * size, 2 * size);
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
