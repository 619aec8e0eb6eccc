// Charts over time.

const charts = [];
const onTimesShown = linkTimes(() => charts.map((chart) => chart.graph), () => {
    if (now !== null) for (const chart of charts) chart.view(now);
});

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
        xLabelHeight: 16, yLabelWidth: 18, axisLabelFontSize: 12, axisLineColor: axisColour, gridLineColor: gridColour,
        axes: {y: {axisLabelWidth: 52, includeZero: chart.fromZero, axisLabelFormatter: tick},
            x: {axisLabelWidth: 44, axisLabelFormatter: tick}},
        dateWindow: [0, duration],
        valueRange: leastRange(chart), yRangePad: 6, hideOverlayOnMouseOut: false,
        stackedGraph: chart.stacked, stackedGraphNaNFill: 'none', fillAlpha: 0.75,
        highlightCallback: (event, t) => hover(t),
        clickCallback: (event, t) => click(t),
        drawCallback: onTimesShown,
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
