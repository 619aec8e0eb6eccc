// What all parts of the page use. The files of this folder become one script, in the order of report_assets.cmake.
// All data stand in the page; nothing is fetched. Times are seconds since the first field.

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
