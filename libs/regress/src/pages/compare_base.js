// Shared by the parts of compare.html, which become one script in the order of pages.cmake.

/** The changes of each rawlog, the worst first. */
const changesOf = new Map(data.ids.map((id) => [id, []]));
for (const change of data.changes) {
    if (change.severity === null) change.severity = Infinity;  // JSON knows none
    changesOf.get(change.id).push(change);
}

const plural = (number, noun) => `${number} ${noun}${number === 1 ? '' : 's'}`;

/** In tolerances. */
const severityText = (severity) => severity === Infinity ? '∞' : severity >= 9.95 ? severity.toFixed(0) : severity.toFixed(1);

/** A number for people: about four digits. */
function numberText(value) {
    if (!Number.isFinite(value)) return '–';
    const size = Math.abs(value);
    return value.toFixed(Number.isInteger(value) ? 0 : size >= 100 ? 1 : size >= 1 ? 2 : size >= 0.01 ? 3 : 5);
}

const colourOf = {worse: channels(colour('vermilion')), better: channels(colour('blue')), '': [110, 110, 110]};

/** How strong the colour of a change is, 0 to 1: pale within tolerance, full from 20 tolerances on. */
function strength(severity) {
    if (severity <= 1) return 0.13;
    return Math.min(1, 0.3 + 0.7 * Math.log(severity) / Math.log(20));
}

/** Gives an element the colour of a change. */
function shade(box, verdict, severity) {
    const part = strength(severity);
    const shaded = colourOf[verdict].map((channel) => Math.round(255 + part * (channel - 255)));
    box.style.background = `rgb(${shaded})`;
    box.style.color = part > 0.6 ? '#fff' : '#1e1e1e';
    return box;
}
