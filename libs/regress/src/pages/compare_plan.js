// Pictures seen from above, with equal scales: ways and maps.

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
    return {x: spanOf(ways.flatMap((way) => way.x), 0.06), y: spanOf(ways.flatMap((way) => way.y), 0.06)};
}

/** What holds both. */
const together = (one, other) => ({x: [Math.min(one.x[0], other.x[0]), Math.max(one.x[1], other.x[1])],
    y: [Math.min(one.y[0], other.y[0]), Math.max(one.y[1], other.y[1])]});

/** A canvas with an image below and ways above; as high as one that shows `shape`, which has no axes. */
class Plan extends PlanCanvas {
    constructor(canvas, {bounds, map = null, image = null, ways = {}, shape = null}) {
        super(canvas);
        Object.assign(this, {bounds, map, ways, shape: shape || bounds});
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
        const {x, y} = this.shape;
        const height = Math.min(Math.max(width * (y[1] - y[0]) / (x[1] - x[0]), 200), 420);
        const tall = height - top - 40 * axes - 1;
        return this.place(this.bounds, {width, height, left, top, inner, tall});
    }

    draw() {
        const at = this.layout(), pen = this.begin(at);
        pen.imageSmoothingEnabled = false;
        if (this.image) this.drawImage(pen, at, this.image, this.map, 'rgb(205,205,205)');
        else this.drawGrid(pen, at, gridColour);
        for (const key of ['truth', 'a', 'b']) if (this.ways[key]) this.drawWay(pen, at, key);
        this.drawEnds(pen, at);
        if (this.image) this.drawScale(pen, at);
        pen.restore();
        pen.strokeStyle = '#777';
        pen.lineWidth = 1;
        pen.strokeRect(at.left, at.top, at.inner, at.tall);
        if (!this.image) this.drawLabels(pen, at);
    }

    drawWay(pen, at, key) {
        const {x, y} = this.ways[key];
        pen.strokeStyle = looks[key].colour;
        pen.lineWidth = this.image ? 2 : looks[key].width;
        this.drawLine(pen, at, x, y);
    }

    /** A ring where each way starts, a square where it ends. */
    drawEnds(pen, at) {
        pen.lineWidth = 1.8;
        pen.fillStyle = '#fff';
        for (const key of ['a', 'b']) {
            const way = this.ways[key];
            if (!way) continue;
            pen.strokeStyle = looks[key].colour;
            this.markEnds(pen, at, way.x, way.y, key === 'a' ? 5 : 3);
            if (key === 'a') pen.fill();
            pen.stroke();
        }
    }
}
