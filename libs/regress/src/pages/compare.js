// Which rawlog is shown.

let chosen = null;

function optionText(id) {
    const changes = changesOf.get(id);
    if (!changes.length) return id + ' — no change';
    const severity = changes[0].severity === Infinity ? 'another outcome' : `up to ${severityText(Math.max(...changes.map((c) => c.severity)))} tolerances`;
    return `${id} — ${plural(changes.length, 'change')}, ${severity}`;
}

/** The largest changes of a rawlog. */
function headline(id) {
    const changes = [...changesOf.get(id)].sort((one, other) => other.severity - one.severity || 0);
    if (!changes.length) return [element('span', {textContent: 'Every figure is the same.'})];
    return changes.slice(0, 4).map((change) => {
        const text = `${change.figure || outcome_name} ${change.figure ? `${change.a} → ${change.b}` : change.b}`;
        return shade(element('span', {className: 'chip', textContent: text, title: tooltip(change)}), change.verdict, change.severity);
    });
}

function drawChoice() {
    const box = element('select', {id: 'rawlog'});
    for (const id of data.ids) box.append(element('option', {value: id, textContent: optionText(id), selected: id === chosen}));
    box.addEventListener('change', () => choose(box.value));
    byId('choice').replaceChildren(element('h2', {textContent: 'One rawlog'}),
        element('p', {className: 'pick'}, box, element('span', {className: 'help', textContent: 'the keys ← and → go through them'})),
        element('p', {className: 'chips'}, ...headline(chosen)));
}

function choose(id) {
    if (id === chosen) return;
    chosen = id;
    history.replaceState(null, '', '#id=' + encodeURIComponent(id));
    for (const row of document.querySelectorAll('.glance tbody tr, .thumbs figure')) row.classList.toggle('chosen', row.dataset.id === id);
    drawChoice();
    drawDrive(id);
    document.body.dataset.id = id;
}

/** The address may say which: compare.html#id=NAME. */
function readAddress() {
    const wanted = new URLSearchParams(location.hash.slice(1)).get('id');
    if (data.ids.includes(wanted)) choose(wanted);
}

function step(event) {
    const by = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (!by || event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === 'SELECT') return;
    const next = data.ids[data.ids.indexOf(chosen) + by];
    if (next === undefined) return;
    event.preventDefault();
    choose(next);
}

if (data.ids.length) {
    drawGlance();
    drawThumbs();
    drawChanges();
    readAddress();
    if (chosen === null) choose(data.ids[0]);
    addEventListener('hashchange', readAddress);
    addEventListener('keydown', step);
}
