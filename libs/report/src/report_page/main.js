// All together.

function follow(fragment) {
    const asked = /^#t=(\d+(\.\d*)?)$/.exec(fragment);
    if (asked) pin(Number(asked[1]));
    return asked !== null;
}

addPlans();
addStatus(byId('charts'));
for (const chart of data.charts) addChart(chart, byId('charts'));
addTiming();
addPictures();
addEventListener('keydown', onKey);
addEventListener('hashchange', () => follow(location.hash));
if (!follow(location.hash)) {
    // Begin where there is most to see.
    const middle = data.pictures[data.pictures.length >> 1] || {t: 0, points: []};
    show(data.pictures.reduce((best, one) => one.points.length > best.points.length ? one : best, middle).t);
}
