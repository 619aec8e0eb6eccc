// The script of sweep.html.
(() => {
const shades = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];  // viridis
const line_colours = [...['blue', 'vermilion', 'green', 'purple', 'orange', 'sky-blue', 'black'].map(colour), '#8c564b'];
const preferred = ['written.obstacle_points', 'errors.ground_truth.omega_cycle_rms_degps', 'status.ok'];
const reach = {
    mean: {name: 'mean over the rawlogs', of: (values) => values.reduce((sum, v) => sum + v, 0) / values.length},
    worst: {name: 'the worst rawlog', of: (values, figure) => worst(values, figure.better)},
    sum: {name: 'sum over the rawlogs', of: (values) => values.reduce((sum, v) => sum + v, 0)},
};
const state = {figure: 0, over: 'mean', x: 0, y: data.axes.length > 1 ? 1 : -1, fixed: data.axes.map(() => 0)};

/** How bad a value is; null where nobody knows. */
function badness(value, better) {
    return {lower: value, higher: -value, zero: Math.abs(value)}[better] ?? null;
}

function worst(values, better) {
    return values.reduce((a, b) => (badness(b, better) ?? b) > (badness(a, better) ?? a) ? b : a);
}

/** Index of a combination: the last axis changes fastest. */
const pointOf = (indices) => indices.reduce((point, index, k) => point * data.axes[k].values.length + index, 0);

function indicesOf(point) {
    const indices = [];
    for (let k = data.axes.length - 1; k >= 0; --k) {
        indices[k] = point % data.axes[k].values.length;
        point = Math.floor(point / data.axes[k].values.length);
    }
    return indices;
}

/** The figure at a combination, over what was chosen: a number or null. */
function valueAt(point) {
    const figure = data.figures[state.figure];
    const row = figure.values[point];
    if (!(state.over in reach)) return row[Number(state.over)];
    const known = row.filter((value) => value !== null);
    return known.length ? reach[state.over].of(known, figure) : null;
}

function text(value) {
    if (value === null) return '–';
    const size = Math.abs(value);
    return Number.isInteger(value) ? String(value) : value.toFixed(size >= 100 ? 1 : size >= 1 ? 2 : size >= 0.01 ? 4 : 6);
}

function at(xIndex, yIndex) {
    const indices = [...state.fixed];
    indices[state.x] = xIndex;
    if (state.y >= 0) indices[state.y] = yIndex;
    return pointOf(indices);
}

function shade(part) {
    const place = part * (shades.length - 1);
    const low = Math.min(Math.floor(place), shades.length - 2);
    return shades[low].map((from, k) => Math.round(from + (place - low) * (shades[low + 1][k] - from)));
}

/** The best of all values, where one way is better. */
function best(values) {
    const better = data.figures[state.figure].better;
    const known = values.filter((value) => value !== null);
    if (!better || !known.length) return null;
    return known.reduce((a, b) => badness(b, better) < badness(a, better) ? b : a);
}

function select(label, options, chosen, choose) {
    const box = element('select', {});
    for (const [value, name] of options) box.append(element('option', {value, textContent: name, selected: String(value) === String(chosen)}));
    box.addEventListener('change', () => { choose(box.value); draw(); });
    return element('label', {}, label, box);
}

function drawChoice() {
    const axes = data.axes.map((axis, k) => [k, axis.key]);
    const parts = [
        select('figure', data.figures.map((f, k) => [k, f.name]), state.figure, (v) => { state.figure = Number(v); }),
        select('over', [...Object.entries(reach).map(([k, r]) => [k, r.name]), ...data.ids.map((id, k) => [k, id])], state.over,
            (v) => { state.over = v; }),
    ];
    if (axes.length > 1) {
        parts.push(select('across', axes, state.x, (v) => { if (Number(v) === state.y) state.y = state.x; state.x = Number(v); }));
        parts.push(select('down', axes, state.y, (v) => { if (Number(v) === state.x) state.x = state.y; state.y = Number(v); }));
    }
    data.axes.forEach((axis, k) => {
        if (k === state.x || k === state.y) return;
        parts.push(select(axis.key + ' is', axis.values.map((v, i) => [i, v]), state.fixed[k], (v) => { state.fixed[k] = Number(v); }));
    });
    byId('choice').replaceChildren(...parts);
}

function note() {
    const better = {lower: 'Lower is better', higher: 'Higher is better', zero: 'Nearer to zero is better'}[data.figures[state.figure].better];
    return better ? better + '; the best is framed.' : 'Neither way is better by itself.';
}

function cell(value, low, high, top) {
    if (value === null) return element('td', {className: 'none', textContent: '–'});
    const shown = shade(high > low ? (value - low) / (high - low) : 0.5);
    const light = shown[0] * 0.299 + shown[1] * 0.587 + shown[2] * 0.114 > 140;
    const made = element('td', {textContent: text(value), className: value === top ? 'best' : ''});
    made.style.background = `rgb(${shown})`;
    made.style.color = light ? '#000' : '#fff';
    return made;
}

function drawHeat() {
    const across = data.axes[state.x];
    const down = state.y >= 0 ? data.axes[state.y] : {key: '', values: ['']};
    const values = down.values.map((_, j) => across.values.map((__, i) => valueAt(at(i, j))));
    const known = values.flat().filter((value) => value !== null);
    const low = Math.min(...known), high = Math.max(...known), top = best(values.flat());
    const head = [element('th', {className: 'key', textContent: down.key ? `${down.key} ↓  ${across.key} →` : across.key + ' →'}),
        ...across.values.map((value) => element('th', {className: 'value', textContent: value}))];
    const rows = down.values.map((value, j) => element('tr', {}, element('th', {className: 'value', textContent: value}),
        ...values[j].map((one) => cell(one, low, high, top))));
    byId('heat').replaceChildren(element('h2', {textContent: data.figures[state.figure].name}),
        element('div', {className: 'wide'}, table('heat', head, rows)),
        element('p', {className: 'help', textContent: note()}));
}

function drawCurves() {
    const across = data.axes[state.x];
    const down = state.y >= 0 ? data.axes[state.y] : {key: '', values: ['']};
    const numbers = across.values.map(Number);
    const places = numbers.every(Number.isFinite) ? numbers : across.values.map((_, i) => i);
    const order = places.map((_, i) => i).sort((a, b) => places[a] - places[b]);
    const rows = order.map((i) => [places[i], ...down.values.map((_, j) => valueAt(at(i, j)))]);
    const names = down.values.map((value) => down.key ? `${down.key} = ${value}` : data.figures[state.figure].name);
    const labels = element('div', {className: 'legend'});
    const plot = element('div', {className: 'plot'});
    byId('curves').replaceChildren(element('h2', {textContent: `Over ${across.key}`}), labels, plot);
    names.forEach((name, j) => {
        const mark = element('u', {});
        mark.style.borderTopColor = line_colours[j % line_colours.length];
        labels.append(element('span', {}, mark, name));
    });
    const ticker = () => order.map((i) => ({v: places[i], label: across.values[i]}));
    new Dygraph(plot, rows, {
        labels: ['x', ...names.map((name, j) => `${j}: ${name}`)], colors: names.map((_, j) => line_colours[j % line_colours.length]),
        drawPoints: true, pointSize: 4, strokeWidth: 2, legend: 'never', xlabel: across.key, ylabel: data.figures[state.figure].name,
        xRangePad: 12, yRangePad: 12, axisLabelFontSize: 12, gridLineColor: gridColour,
        axes: {x: {ticker, axisLabelWidth: 60}, y: {axisLabelWidth: 64, axisLabelFormatter: (value) => String(Number(value.toPrecision(6)))}},
    });
}

function drawRanking() {
    const better = data.figures[state.figure].better;
    const points = data.figures[state.figure].values.map((_, point) => ({point, value: valueAt(point)})).filter((p) => p.value !== null);
    points.sort((a, b) => better ? badness(a.value, better) - badness(b.value, better) : b.value - a.value);
    const rows = points.slice(0, 20).map(({point, value}, k) => element('tr', {className: k === 0 && better ? 'best' : ''},
        ...indicesOf(point).map((index, axis) => element('td', {className: 'number', textContent: data.axes[axis].values[index]})),
        element('td', {className: 'number', textContent: text(value)})));
    const head = [...data.axes.map((axis) => axis.key), data.figures[state.figure].name];
    byId('ranking').replaceChildren(element('h2', {textContent: better ? 'The best combinations' : 'The highest values'}),
        element('div', {className: 'wide'}, table('', head.map((name) => element('th', {className: 'number', textContent: name})), rows)));
}

function draw() {
    drawChoice();
    drawHeat();
    drawCurves();
    drawRanking();
}

/** The address may say what to show: sweep.html#figure=NAME&over=worst. */
function readAddress() {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const figure = data.figures.findIndex((f) => f.name === wanted.get('figure'));
    if (figure >= 0) state.figure = figure;
    const over = wanted.get('over');
    if (over in reach) state.over = over;
    if (data.ids.includes(over)) state.over = String(data.ids.indexOf(over));
}

if (!data.figures.length) {
    byId('choice').append('No figure differs between the combinations.');
    return;
}
state.figure = Math.max(0, data.figures.findIndex((f) => preferred.includes(f.name)));
for (const name of [...preferred].reverse()) {
    const k = data.figures.findIndex((f) => f.name === name);
    if (k >= 0) state.figure = k;
}
readAddress();
window.addEventListener('hashchange', () => { readAddress(); draw(); });
draw();
})();
