// Makes report.html follow the cursor: every chart, the way, the map and the pictures show the same moment. All data
// stand in the page; nothing is fetched. Times are seconds since the first field.
'use strict';
(() => {
    const data = JSON.parse(document.getElementById('data').textContent);
    const byId = (id) => document.getElementById(id);
    document.documentElement.classList.add('js');

    /** A new element with properties; children may be elements or text. */
    function element(name, properties, ...children) {
        const made = Object.assign(document.createElement(name), properties);
        made.append(...children);
        return made;
    }

    /** Index of the time nearest to t; times rise. */
    function nearest(times, t) {
        let low = 0, high = times.length - 1;
        while (low < high) {
            const middle = (low + high) >> 1;
            if (times[middle] < t) low = middle + 1; else high = middle;
        }
        return low > 0 && t - times[low - 1] <= times[low] - t ? low - 1 : low;
    }

    /** A number for people: about four digits. */
    function text(value) {
        if (value === null || value === undefined || Number.isNaN(value)) return '–';
        const size = Math.abs(value);
        return value.toFixed(Number.isInteger(value) ? 0 : size >= 100 ? 1 : size >= 1 ? 2 : 3);
    }

    /** A label of an axis: no exponents, no noise of binary fractions. */
    const tick = (value) => String(Number(value.toPrecision(8)));

    // ---- the moment shown

    const duration = Math.max(...data.tracks[0].t);
    const viewers = [];  // functions of a time
    let now = null;
    let pinned = false;

    function show(t) {
        now = Math.min(Math.max(t, 0), duration);
        document.body.dataset.t = now.toFixed(3);
        for (const view of viewers) view(now);
    }

    function hover(t) {
        show(pinned ? now : t);
    }

    function remember(fragment) {
        history.replaceState(null, '', location.href.split('#')[0] + fragment);
    }

    function pin(t) {
        pinned = true;
        document.body.classList.add('pinned');
        show(t);
        remember('#t=' + now.toFixed(3).replace(/\.?0+$/, ''));
    }

    function unpin() {
        pinned = false;
        document.body.classList.remove('pinned');
        remember('');
    }

    function click(t) {
        if (pinned) unpin(); else pin(t);
        show(pinned ? now : t);
    }

    // ---- charts over time

    const charts = [];
    const gap = (value) => value === false ? NaN : value;
    let linking = false;

    /** All charts show the times that `source` shows. */
    function link(source) {
        if (linking) return;
        linking = true;
        const range = source.xAxisRange();
        for (const chart of charts) {
            const [from, to] = chart.graph.xAxisRange();
            if (from !== range[0] || to !== range[1]) chart.graph.updateOptions({dateWindow: range});
        }
        linking = false;
        if (now !== null) for (const chart of charts) chart.view(now);
    }

    /** Lowest and highest value when they are too close to fill a chart, else null: as the data have it. */
    function leastRange(chart) {
        const values = chart.series.flatMap((s) => s.values).filter(Number.isFinite);
        const low = Math.min(...values), high = Math.max(...values);
        if (!values.length || high - low >= chart.leastSpan || chart.stacked) return null;
        const from = chart.fromZero && low >= 0 ? 0 : (low + high - chart.leastSpan) / 2;
        return [from, Math.max(from + chart.leastSpan, high)];
    }

    /** The value at a time; of a series that has few, the last before. */
    function valueAt(chart, series, t) {
        for (let i = nearest(chart.t, t); i >= 0; --i) {
            const value = gap(series.values[i]);
            if (value !== null || !series.connected) return value;
        }
        return null;
    }

    function legendOf(chart) {
        return (shown) => shown.series.map((s) => {
            const look = chart.series.find((one) => one.name === s.label);
            const t = shown.x === undefined ? now : shown.x;  // outside of what is zoomed to nothing is selected
            const value = t === null ? '' : '<b>' + text(valueAt(chart, look, t)) + '</b>';
            const line = look.dashed ? 'dashed' : 'solid';
            const mark = chart.stacked ? `<i style="background:${look.colour}"></i>`
                : `<u style="border-top:${Math.min(look.width + 1, 5)}px ${line} ${look.colour}"></u>`;
            return `<span>${mark}${s.label}${value}</span>`;
        }).join('') + (chart.unit ? `<span class="unit">${chart.unit}</span>` : '');
    }

    function optionsOf(chart, labels) {
        const series = {};
        for (const s of chart.series) {
            series[s.name] = {
                color: s.colour, strokeWidth: s.width, strokePattern: s.dashed ? [7, 4] : null,
                connectSeparatedPoints: s.connected, highlightCircleSize: 4,
            };
        }
        return {
            labels: ['t', ...chart.series.map((s) => s.name)], series,
            labelsDiv: labels, legend: 'always', legendFormatter: legendOf(chart),
            xlabel: 'time since the first field (s)', ylabel: chart.unit ? `${chart.quantity} (${chart.unit})` : chart.quantity || ' ',
            xLabelHeight: 16, yLabelWidth: 18, axisLabelFontSize: 12, axisLineColor: '#555', gridLineColor: '#e4e4e4',
            axes: {y: {axisLabelWidth: 52, includeZero: chart.fromZero, axisLabelFormatter: tick},
                x: {axisLabelWidth: 44, axisLabelFormatter: tick}},
            dateWindow: [0, duration],
            valueRange: leastRange(chart), yRangePad: 6, hideOverlayOnMouseOut: false,
            stackedGraph: chart.stacked, stackedGraphNaNFill: 'none', fillAlpha: 0.75,
            highlightCallback: (event, t) => hover(t),
            clickCallback: (event, t) => click(t),
            drawCallback: (graph, initial) => initial || link(graph),
        };
    }

    function addChart(chart, parent, more = {}) {
        if (!chart.t.length) return;
        const labels = element('div', {className: 'legend'});
        const plot = element('div', {className: 'plot'});
        const cursor = element('div', {className: 'cursor'});
        const frame = element('div', {className: 'frame'}, plot, cursor);
        parent.append(element('figure', {className: 'chart', id: 'chart-' + chart.id},
            element('h3', {textContent: chart.title}), labels, frame,
            element('figcaption', {textContent: chart.note || ''})));
        if (more.height) plot.style.height = more.height + 'px';
        const rows = chart.t.map((t, i) => [t, ...chart.series.map((s) => gap(s.values[i]))]);
        const graph = new Dygraph(plot, rows, {...optionsOf(chart, labels), ...more.options});
        const place = (t) => {
            const area = graph.getArea();
            const x = t === null ? -1 : graph.toDomXCoord(t);
            cursor.hidden = x < area.x - 1 || x > area.x + area.w + 1;
            cursor.style.cssText = `left:${x}px; top:${area.y}px; height:${area.h}px`;
        };
        const view = (t) => {
            graph.setSelection(nearest(chart.t, t));
            place(t);
        };
        charts.push({graph, view});
        viewers.push(view);
        if (now !== null) view(now);
    }

    function statusAt(t) {
        const runs = data.status.runs;
        const i = runs.findIndex((run) => t < run[1]);
        return data.status.kinds[runs[i < 0 ? runs.length - 1 : i][2]];
    }

    function addStatus(parent) {
        const chart = {
            id: 'status', title: 'Status', quantity: '', unit: '', stacked: false, leastSpan: 1, t: data.tracks[0].t,
            note: 'Green: the motion was measured. What the others mean stands in the table of statuses below.',
            series: [{name: 'status', colour: 'transparent', width: 0.1, values: data.tracks[0].t.map(() => 0)}],
        };
        const paint = (context, area, graph) => {
            for (const [from, to, kind] of data.status.runs) {
                const left = Math.max(area.x, graph.toDomXCoord(from));
                const right = Math.min(area.x + area.w, graph.toDomXCoord(to));
                context.fillStyle = data.status.kinds[kind].colour;
                if (right > left) context.fillRect(left, area.y, Math.max(right - left, 1), area.h);
            }
        };
        const used = new Set(data.status.runs.map((run) => run[2]));
        const kinds = data.status.kinds.filter((kind, i) => used.has(i));
        const legend = (shown) => kinds.map((kind) => {
            const here = shown.x !== undefined && statusAt(shown.x) === kind;
            return `<span>${here ? '<b>' : ''}<i style="background:${kind.colour}"></i>${kind.name}${here ? '</b>' : ''}</span>`;
        }).join('');
        addChart(chart, parent, {height: 74, options: {
            underlayCallback: paint, legendFormatter: legend, valueRange: [0, 1],
            axes: {y: {axisLabelWidth: 52, ticker: () => [], drawGrid: false},
                x: {axisLabelWidth: 44, axisLabelFormatter: tick}},
        }});
    }

    // ---- the way and the map, seen from above

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

    // ---- the pictures

    const pictureTimes = data.pictures.map((picture) => picture.t);
    const nearestPicture = (t) => nearest(pictureTimes, t);

    function flowAt(id, t) {
        const chart = data.charts.find((one) => one.id === id);
        return valueAt(chart, chart.series.find((one) => one.name === 'flow'), t);
    }

    function describe(t) {
        const i = nearestPicture(t);
        const parts = [`t = ${t.toFixed(2)} s`, statusAt(t).name, `turn ${text(flowAt('turn', t))} deg/s`,
            `speed ${text(flowAt('speed', t))} m/s`];
        if (i >= 0) parts.push(`picture of ${pictureTimes[i].toFixed(2)} s`, `${data.pictures[i].points.length} obstacle points`);
        if (pinned) parts.push('pinned');
        byId('readout').replaceChildren(...parts.flatMap((part) => [element('span', {textContent: part}), ' ']));
    }

    function addPictures() {
        viewers.push(describe);
        const figures = [...document.querySelectorAll('#strip figure')];
        const cells = [...document.querySelectorAll('[data-key^="fate."] .number')].reverse();
        if (!figures.length) return;
        let shown = -1;
        viewers.push((t) => {
            const i = nearestPicture(t);
            if (i === shown) return;
            if (shown >= 0) figures[shown].classList.remove('current');
            shown = i;
            figures[i].classList.add('current');
            const image = figures[i].querySelector('img');
            byId('large').src = image.src;
            byId('large').alt = image.alt;
            byId('strip').scrollLeft = figures[i].offsetLeft - (byId('strip').clientWidth - figures[i].offsetWidth) / 2;
            data.pictures[i].fates.forEach((count, k) => { cells[k].textContent = count; });
        });
        figures.forEach((figure, i) => figure.addEventListener('click', () => pin(pictureTimes[i])));
    }

    function step(times, by) {
        if (times.length) pin(times[Math.min(Math.max(nearest(times, now) + by, 0), times.length - 1)]);
    }

    function onKey(event) {
        if (event.target.tagName === 'INPUT' || event.ctrlKey || event.altKey || event.metaKey) return;
        const by = {ArrowLeft: -1, ArrowRight: 1}[event.key];
        if (event.key === 'Escape') { unpin(); show(now); }
        if (!by) return;
        event.preventDefault();
        step(event.shiftKey ? data.tracks[0].t : pictureTimes, by);
    }

    // ---- time per stage

    const stages = [
        ['decode', '#999999', 'reading the recording, decoding images'],
        ['match', '#0072b2', 'finding the blocks of the reference in the new field'],
        ['motion', '#009e73', 'turn rate, pitch rate and travel, and what is an obstacle'],
        ['map', '#e69f00', 'entering points and floor into the map'],
        ['write', '#cc79a7', 'writing the files, and drawing the pictures of this page'],
    ];

    function showTiming(timing) {
        const place = byId('times');
        const series = stages.map(([name, colour]) => ({
            name, colour, dashed: false, width: 1, connected: false, values: timing.per_field[name + '_ms']}));
        if (!byId('chart-timing')) {
            addChart({id: 'timing', title: 'Time per field', quantity: 'time', unit: 'ms', stacked: true, fromZero: true, leastSpan: 0,
                note: 'Stacked; means over short stretches of the drive.', t: timing.per_field.t_s, series}, place);
        }
        const fields = timing.fields_per_s * timing.total_s;
        const cells = (...texts) => texts.map((content, i) => element('td', {textContent: content, className: i % 3 ? 'number' : ''}));
        const body = element('tbody', {}, ...stages.map(([name, , meaning]) => {
            const seconds = timing.stages[name + '_s'];
            return element('tr', {}, ...cells(name, text(seconds), text(1000 * seconds / fields), meaning));
        }));
        const head = element('thead', {}, element('tr', {}, ...['stage', 's', 'ms a field', 'meaning'].map((name, i) =>
            element('th', {textContent: name, className: i % 3 ? 'number' : ''}))));
        const total = `${text(timing.total_s)} s in all, ${text(timing.fields_per_s)} fields a second, ` +
            `${timing.threads} thread${timing.threads > 1 ? 's' : ''}, matching kernel ${timing.kernel}.`;
        place.querySelectorAll('table, p').forEach((old) => old.remove());
        place.append(element('table', {}, head, body), element('p', {textContent: total}));
    }

    async function takeSummary(file) {
        const place = byId('times');
        try {
            const summary = JSON.parse(await file.text());
            if (summary.input.file !== data.input) throw new Error(`it is of ${summary.input.file}`);
            showTiming(summary.timing);
        } catch (error) {
            place.replaceChildren(element('p', {className: 'bad',
                textContent: `${file.name} is not the summary.json of this drive: ${error.message}`}));
        }
    }

    function addTiming() {
        if (data.timing) showTiming(data.timing);
        byId('summary').addEventListener('change', (event) => takeSummary(event.target.files[0]));
        addEventListener('dragover', (event) => event.preventDefault());
        addEventListener('drop', (event) => {
            event.preventDefault();
            if (event.dataTransfer.files.length) takeSummary(event.dataTransfer.files[0]);
        });
    }

    // ---- all together

    function follow(fragment) {
        const asked = /^#t=(\d+(\.\d*)?)$/.exec(fragment);
        if (asked) pin(Number(asked[1]));
        return asked !== null;
    }

    addPlans();
    addStatus(byId('charts'));
    for (const chart of data.charts) addChart(chart, byId('charts'));
    addTiming();
    addPictures();
    addEventListener('keydown', onKey);
    addEventListener('hashchange', () => follow(location.hash));
    if (!follow(location.hash)) {
        // Begin where there is most to see.
        const middle = data.pictures[data.pictures.length >> 1] || {t: 0, points: []};
        show(data.pictures.reduce((best, one) => one.points.length > best.points.length ? one : best, middle).t);
    }
})();
