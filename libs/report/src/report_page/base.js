// Shared by the parts of report.html, which become one script in the order of report_assets.cmake. Times are seconds
// since the first field.

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
