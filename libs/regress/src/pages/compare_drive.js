// One rawlog: ways, maps and curves of both runs.

let plans = [], graphs = [];
const onTimesShown = linkTimes(() => graphs);

function figure(title, caption, legend) {
    const canvas = element('canvas', {});
    const frame = element('div', {className: 'frame'}, canvas);
    return {canvas, box: element('figure', {className: 'plan'}, element('h3', {textContent: title}), legend, frame,
        element('figcaption', {textContent: caption}))};
}

/** How far apart the ways end, in words. */
function endsText({a, b}) {
    if (!a || !b) return `Only ${a ? 'A' : 'B'} has a way.`;
    const end = (way) => [way.x[way.x.length - 1], way.y[way.y.length - 1]];
    const [xa, ya] = end(a), [xb, yb] = end(b), apart = Math.hypot(xb - xa, yb - ya);
    return apart < 0.0005 ? 'Both ways end at the same place.' : `The ways end ${apart.toFixed(3)} m apart.`;
}

/** What is seen of the maps: they and the ways. */
function viewOf({ways, maps}) {
    const driven = [ways?.a, ways?.b].filter(Boolean);
    return driven.length ? together(boundsOfMap(maps), boundsOfWays(driven)) : boundsOfMap(maps);
}

function addWays(parent, drive) {
    const {ways, maps} = drive;
    if (!ways) return;
    const keys = ['truth', 'a', 'b'].filter((key) => ways[key]);
    const {canvas, box} = figure('Ways', endsText(ways), lineLegend(keys));
    parent.append(box);
    plans.push(new Plan(canvas, {bounds: boundsOfWays(keys.map((key) => ways[key])), ways, shape: maps && viewOf(drive)}));
}

function addMaps(parent, drive) {
    const {maps, ways} = drive;
    if (!maps) return;
    const {onlyA, onlyB, both} = maps, bounds = viewOf(drive);
    const size = `${numberText(maps.columns * maps.cell)} m × ${numberText(maps.rows * maps.cell)} m, cells of ${numberText(maps.cell)} m.`;
    const legends = {
        difference: cellLegend([['#3c3c3c', `occupied in both: ${both}`], [data.colours.a, `only in A: ${onlyA}`], [data.colours.b, `only in B: ${onlyB}`]]),
        a: cellLegend([['#000', `occupied: ${both + onlyA} cells`]]),
        b: cellLegend([['#000', `occupied: ${both + onlyB} cells`]]),
    };
    const add = (key, title, caption, shown) => {
        const {canvas, box} = figure(title, caption, legends[key]);
        canvas.dataset.map = key;
        parent.append(box);
        plans.push(new Plan(canvas, {bounds, map: maps, image: maps[key], ways: shown}));
    };
    const same = onlyA + onlyB === 0 ? 'Both maps have the same occupied cells. ' : '';
    add('difference', 'What differs between the maps', same + size, {});
    add('a', 'Map of A', 'Black: occupied, white: free, grey: unknown.', {a: ways?.a});
    add('b', 'Map of B', 'Black: occupied, white: free, grey: unknown.', {b: ways?.b});
}

// Curves

function optionsOf(chart, times) {
    return {
        legend: 'never', axisLabelFontSize: 12, axisLineColor: axisColour, gridLineColor: gridColour, yLabelWidth: 16, xLabelHeight: 16,
        connectSeparatedPoints: true, dateWindow: times, yRangePad: 6, highlightCircleSize: 3,
        axes: {y: {axisLabelWidth: 50, axisLabelFormatter: tick, pixelsPerLabel: 18}, x: {axisLabelWidth: 44, axisLabelFormatter: tick}},
        drawCallback: onTimesShown,
    };
}

/** Lowest and highest value, at least as far apart as makes sense. */
function rangeOf(chart, values) {
    let low = Infinity, high = -Infinity;
    for (const value of values) if (Number.isFinite(value)) { low = Math.min(low, value); high = Math.max(high, value); }
    if (low > high) return null;
    if (chart.fromZero) low = Math.min(0, low);
    const missing = Math.max(0, chart.leastSpan - high + low), room = 0.06 * (high - low + missing);
    return chart.fromZero && low === 0 ? [0, high + missing + room] : [low - missing / 2 - room, high + missing / 2 + room];
}

function addGraph(parent, className, rows, options) {
    const plot = element('div', {className});
    parent.append(plot);
    graphs.push(new Dygraph(plot, rows, options));
}

/** The values at the mouse; where one comes less often, the last before. */
function readout(chart, box) {
    const last = (values, row) => {
        while (row > 0 && values[row] === null) --row;
        return gap(values[row]) ?? NaN;
    };
    const show = (event, t, points, row) => {
        const [a, b] = [last(chart.a, row), last(chart.b, row)];
        const difference = numberText(Number((b - a).toFixed(chart.decimals)));
        box.textContent = `${t.toFixed(2)} s: A ${numberText(a)}, B ${numberText(b)}, B − A ${difference} ${chart.unit}`;
    };
    return {highlightCallback: show, unhighlightCallback: () => { box.textContent = chart.unit; }};
}

const valuesOf = (chart) => chart.t.map((t, i) => [t, gap(chart.a[i]), gap(chart.b[i])]);
const differencesOf = (chart) => chart.t.map((t, i) => [t, gap(chart.difference[i])]);
const differs = (chart) => chart.a.some((value, i) => value !== chart.b[i]);

function addChart(parent, chart, times) {
    const values = element('span', {className: 'unit', textContent: chart.unit});
    const box = element('figure', {className: 'chart'}, element('h3', {textContent: chart.title}), lineLegend(['a', 'b'], [values]));
    box.dataset.id = chart.id;
    parent.append(box);
    const rows = valuesOf(chart), unit = chart.unit ? ` (${chart.unit})` : '';
    addGraph(box, 'plot', rows, {...optionsOf(chart, times), ...readout(chart, values), labels: ['t', 'A', 'B'],
        valueRange: rangeOf(chart, rows.flatMap((row) => row.slice(1))), ylabel: chart.unit || 'count',
        series: {A: {color: looks.a.colour, strokeWidth: looks.a.width}, B: {color: looks.b.colour, strokeWidth: looks.b.width}}});
    if (differs(chart)) {
        addGraph(box, 'plot low', differencesOf(chart), {...optionsOf(chart, times), labels: ['t', 'B − A'], colors: ['#333'], fillGraph: true,
            fillAlpha: 0.3, strokeWidth: 1.2, includeZero: true, ylabel: 'B − A', xlabel: 'time since the first field (s)'});
    } else {
        box.append(element('p', {className: 'equal', textContent: 'The same in both.'}));
    }
    box.append(element('figcaption', {textContent: chart.note}));
}

function addCurves(parent, charts) {
    const last = Math.max(...charts.map((chart) => chart.t[chart.t.length - 1] || 0));
    const order = [...charts.filter(differs), ...charts.filter((chart) => !differs(chart))];
    for (const chart of order) if (chart.t.length) addChart(parent, chart, [0, last || 1]);
}

function drawDrive(id) {
    graphs.forEach((graph) => graph.destroy());
    plans = [];
    graphs = [];
    const box = byId('drive'), drive = data.drives[id];
    box.replaceChildren();
    if (!(id in data.drives)) {
        box.append(element('p', {className: 'help', textContent: `Ways, maps and curves stand here of the ${Object.keys(data.drives).length} rawlogs only that changed most.`}));
        return;
    }
    if (!drive || !(drive.maps || drive.charts.length))
        box.append(element('p', {className: 'help', textContent: 'No maps and curves to compare: a run kept only its figures (--keep figures).'}));
    if (!drive) return;
    const pictures = element('div', {className: 'pictures'}), curves = element('div', {className: 'curves'});
    box.append(pictures, curves);
    addWays(pictures, drive);
    addMaps(pictures, drive);
    addCurves(curves, drive.charts);
}

addEventListener('resize', () => plans.forEach((plan) => plan.draw()));
