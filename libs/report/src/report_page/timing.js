// The time per stage.

const stages = [
    ['decode', colour('grey'), 'reading the recording, decoding images'],
    ['match', colour('blue'), 'finding the blocks of the reference in the new field'],
    ['motion', colour('green'), 'turn rate, pitch rate and travel, and what is an obstacle'],
    ['map', colour('orange'), 'entering points and floor into the map'],
    ['write', colour('purple'), 'writing the files, and drawing the pictures of this page'],
];

function showTiming(timing) {
    const place = byId('times');
    const series = stages.map(([name, shade]) => ({
        name, colour: shade, dashed: false, width: 1, connected: false, values: timing.per_field[name + '_ms']}));
    if (!byId('chart-timing')) {
        addChart({id: 'timing', title: 'Time per field', quantity: 'time', unit: 'ms', stacked: true, fromZero: true, leastSpan: 0,
            note: 'Stacked; means over short stretches of the drive.', t: timing.per_field.t_s, series}, place);
    }
    const fields = timing.fields_per_s * timing.total_s;
    const cells = (...texts) => texts.map((content, i) => element('td', {textContent: content, className: i % 3 ? 'number' : ''}));
    const rows = stages.map(([name, , meaning]) => {
        const seconds = timing.stages[name + '_s'];
        return element('tr', {}, ...cells(name, text(seconds), text(1000 * seconds / fields), meaning));
    });
    const head = ['stage', 's', 'ms a field', 'meaning'].map((name, i) =>
        element('th', {textContent: name, className: i % 3 ? 'number' : ''}));
    const total = `${text(timing.total_s)} s in all, ${text(timing.fields_per_s)} fields a second, ` +
        `${timing.threads} thread${timing.threads > 1 ? 's' : ''}, matching kernel ${timing.kernel}.`;
    place.querySelectorAll('table, p').forEach((old) => old.remove());
    place.append(table('', head, rows), element('p', {textContent: total}));
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
