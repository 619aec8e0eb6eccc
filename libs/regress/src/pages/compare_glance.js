// What changed: at a glance, and every change.

const most_columns = 10, few_rows = 12;
const outcome_name = 'outcome of the replay';

/** The figures that changed most, over all rawlogs; those that say how good something is count more. */
function mainFigures() {
    const sums = new Map();
    for (const change of data.changes) {
        const weight = change.verdict ? 3 : 1;
        sums.set(change.figure, (sums.get(change.figure) || 0) + weight * Math.min(change.severity, 20));
    }
    return [...sums.keys()].sort((a, b) => sums.get(b) - sums.get(a));
}

/** The name of a figure, to be broken at its words. */
function brokenName(figure) {
    const parts = (figure || outcome_name).split(/(?<=[._])/);
    return parts.flatMap((part) => [part, document.createElement('wbr')]);
}

/** The change as a share, or as it is. */
function shortChange(change) {
    if (!change.figure) return change.b.split(':')[0];
    if (!change.difference) return '→ ' + change.b;
    if (change.share === null) return change.difference;
    const percent = 100 * change.share, size = Math.abs(percent);
    if (size < 0.05) return '≈ 0 %';
    const text = size >= 1000 ? '× ' + numberText(1 + change.share) : percent.toFixed(size < 10 ? 1 : 0) + ' %';
    return (percent > 0 && size < 1000 ? '+' : '') + text.replace('-', '−');
}

function tooltip(change) {
    const severity = change.severity === Infinity ? '' : `, ${severityText(change.severity)} tolerances`;
    return `${change.id}, ${change.figure || outcome_name}: ${change.a} → ${change.b}${severity}${change.verdict && ', ' + change.verdict}`;
}

function glanceRow(id, figures) {
    const of = new Map(changesOf.get(id).map((change) => [change.figure, change]));
    const cells = figures.map((figure) => {
        const change = of.get(figure);
        if (!change) return element('td', {className: 'same', textContent: '='});
        return shade(element('td', {textContent: shortChange(change), title: tooltip(change)}), change.verdict, change.severity);
    });
    const link = element('a', {href: '#id=' + encodeURIComponent(id), textContent: id});
    const row = element('tr', {}, element('th', {}, link), ...cells);
    row.dataset.id = id;
    row.addEventListener('click', () => choose(id));
    return row;
}

function glanceLegend() {
    const mark = (verdict, severity, text) => element('span', {}, shade(element('i', {}), verdict, severity), text);
    return element('p', {className: 'legend'}, mark('worse', 20, 'worse'), mark('better', 20, 'better'),
        mark('', 20, 'changed, neither way is better by itself'), mark('', 1, 'pale: within the tolerance'),
        element('span', {}, 'full: 20 tolerances and more'), element('span', {}, '=  the same'));
}

function drawGlance() {
    const all = mainFigures(), figures = all.slice(0, most_columns);
    const changed = data.ids.filter((id) => changesOf.get(id).length);
    if (!changed.length) return;
    const head = [element('th', {}), ...figures.map((figure) => element('th', {title: figure}, ...brokenName(figure)))];
    const notes = [];
    if (all.length > figures.length) notes.push(`${plural(all.length - figures.length, 'more figure')} changed less: all stand in the table below.`);
    if (changed.length < data.ids.length) notes.push(`Without any change: ${data.ids.slice(changed.length).join(', ')}.`);
    byId('glance').className = figures.length < 5 ? 'few' : '';
    byId('glance').replaceChildren(element('h2', {textContent: 'At a glance'}), glanceLegend(),
        element('div', {className: 'wide tall'}, table('glance', head, changed.map((id) => glanceRow(id, figures)))),
        element('p', {className: 'help', textContent: notes.join(' ')}));
}

/** The differences between the maps of all rawlogs, small. */
function drawThumbs() {
    const boxes = [];
    for (const id of data.ids) {
        const maps = data.drives[id]?.maps;
        if (!maps || maps.onlyA + maps.onlyB === 0) continue;
        const picture = element('img', {src: maps.difference, alt: 'what differs between the maps of ' + id});
        const caption = element('figcaption', {}, id, element('br', {}), element('b', {className: 'in-b', textContent: `+${maps.onlyB}`}), ' ',
            element('b', {className: 'in-a', textContent: `−${maps.onlyA}`}), ` of ${maps.both + maps.onlyA}`);
        const box = element('figure', {}, picture, caption);
        box.dataset.id = id;
        box.addEventListener('click', () => choose(id));
        boxes.push(box);
    }
    if (!boxes.length) return;
    byId('thumbs').replaceChildren(element('h2', {textContent: 'Maps at a glance'}),
        cellLegend([['#3c3c3c', 'occupied in both maps'], [data.colours.a, 'only in A'], [data.colours.b, 'only in B'], ['#fff', 'free'], ['#cdcdcd', 'unknown']]),
        element('div', {className: 'thumbs'}, ...boxes));
}

function cellLegend(parts) {
    return element('div', {className: 'legend'}, ...parts.map(([colour, text]) => {
        const mark = element('i', {});
        mark.style.background = colour;
        return element('span', {}, mark, text);
    }));
}

// Every change

const shown = {only: null, all: false};

function changeRow(change) {
    const id = element('a', {href: '#id=' + encodeURIComponent(change.id), textContent: change.id, title: 'only this rawlog'});
    id.addEventListener('click', () => { shown.only = change.id; drawChanges(); });
    const number = (textContent) => element('td', {className: 'number', textContent});
    const bar = shade(element('span', {className: 'bar', textContent: severityText(change.severity)}), change.verdict, change.severity);
    const row = element('tr', {}, element('td', {}, id), element('td', {textContent: change.figure || outcome_name}),
        ...[change.a, change.b].map((text) => change.figure ? number(text) : element('td', {textContent: text})),
        number(change.difference), element('td', {className: 'number'}, bar), element('td', {textContent: change.verdict}));
    return row;
}

function button(textContent, act) {
    const made = element('button', {type: 'button', textContent});
    made.addEventListener('click', () => { act(); drawChanges(); });
    return made;
}

function drawChanges() {
    if (!data.changes.length) return;
    const changes = shown.only === null ? data.changes : changesOf.get(shown.only);
    const rows = shown.all ? changes : changes.slice(0, few_rows);
    const head = ['rawlog', 'figure', 'A', 'B', 'change', 'tolerances', ''].map((name, k) =>
        element('th', {textContent: name, className: k >= 2 && k <= 5 ? 'number' : ''}));
    const tools = element('p', {className: 'tools'});
    if (rows.length < changes.length) tools.append(button(`Show all ${changes.length}`, () => { shown.all = true; }));
    else if (shown.all && changes.length > few_rows) tools.append(button('Show fewer', () => { shown.all = false; }));
    if (shown.only !== null) tools.append(button('All rawlogs', () => { shown.only = null; }));
    const title = 'Every change' + (shown.only === null ? ', the worst first' : ' of ' + shown.only);
    byId('changes').replaceChildren(element('h2', {textContent: title}),
        element('div', {className: 'wide'}, table('changes', head, rows.map(changeRow))), tools);
}
