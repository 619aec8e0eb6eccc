// The pictures, and stepping through them.

const pictureTimes = data.pictures.map((picture) => picture.t);
const nearestPicture = (t) => nearest(pictureTimes, t);

function flowAt(id, t) {
    const chart = data.charts.find((one) => one.id === id);
    return valueAt(chart, chart.series.find((one) => one.name === 'flow'), t);
}

function describe(t) {
    const i = nearestPicture(t);
    const parts = [`t = ${t.toFixed(2)} s`, statusAt(t).name, `turn ${text(flowAt('turn', t))} deg/s`,
        `speed ${text(flowAt('speed', t))} m/s`];
    if (i >= 0) parts.push(`picture of ${pictureTimes[i].toFixed(2)} s`, `${data.pictures[i].points.length} obstacle points`);
    if (pinned) parts.push('pinned');
    byId('readout').replaceChildren(...parts.flatMap((part) => [element('span', {textContent: part}), ' ']));
}

function addPictures() {
    viewers.push(describe);
    const figures = [...document.querySelectorAll('#strip figure')];
    const cells = [...document.querySelectorAll('[data-key^="label."] .number')].reverse();
    const stripCells = document.querySelectorAll('[data-key^="strip."] .number');
    if (!figures.length) return;
    let shown = -1;
    viewers.push((t) => {
        const i = nearestPicture(t);
        if (i === shown) return;
        if (shown >= 0) figures[shown].classList.remove('current');
        shown = i;
        figures[i].classList.add('current');
        const image = figures[i].querySelector('img');
        byId('large').src = image.src;
        byId('large').alt = image.alt;
        byId('strip').scrollLeft = figures[i].offsetLeft - (byId('strip').clientWidth - figures[i].offsetWidth) / 2;
        data.pictures[i].labels.forEach((count, k) => { cells[k].textContent = count; });
        data.pictures[i].strips.forEach((count, k) => { stripCells[k].textContent = count; });
    });
    figures.forEach((figure, i) => figure.addEventListener('click', () => pin(pictureTimes[i])));
}

function step(times, by) {
    if (times.length) pin(times[Math.min(Math.max(nearest(times, now) + by, 0), times.length - 1)]);
}

function onKey(event) {
    if (event.target.tagName === 'INPUT' || event.ctrlKey || event.altKey || event.metaKey) return;
    const by = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (event.key === 'Escape') { unpin(); show(now); }
    if (!by) return;
    event.preventDefault();
    step(event.shiftKey ? data.tracks[0].t : pictureTimes, by);
}
