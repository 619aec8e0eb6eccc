'use strict';
// Shared by the scripts of all pages. All data stand in the page; nothing is fetched.

const data = JSON.parse(document.getElementById('data').textContent);
const byId = (id) => document.getElementById(id);
document.documentElement.classList.add('js');

/** A new element with properties; children may be elements or text. */
function element(name, properties, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
}

/** A new table; head and rows are cells. */
function table(className, head, rows) {
    return element('table', {className}, element('thead', {}, element('tr', {}, ...head)), element('tbody', {}, ...rows));
}

/** A colour of the palette, by the name of its variable in the style sheet: "#0072b2". */
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

/** Red, green and blue of a colour "#rrggbb", 0 to 255. */
const channels = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));

/** A value of a series for dygraphs: false, an interruption of the line, becomes NaN. */
const gap = (value) => value === false ? NaN : value;

/** A label of an axis: no exponents, no noise of binary fractions. */
const tick = (value) => String(Number(value.toPrecision(8)));

const gridColour = '#e4e4e4', axisColour = '#555';

/** A drawCallback of dygraphs: all charts of `graphs()` show the times that the changed one shows, then `done`. */
function linkTimes(graphs, done = () => {}) {
    let linking = false;
    return (source, initial) => {
        if (initial || linking) return;
        linking = true;
        const range = source.xAxisRange();
        for (const graph of graphs()) {
            const [from, to] = graph.xAxisRange();
            if (from !== range[0] || to !== range[1]) graph.updateOptions({dateWindow: range});
        }
        linking = false;
        done();
    };
}
