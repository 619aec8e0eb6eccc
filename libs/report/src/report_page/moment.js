// The moment that everything shows.

const duration = Math.max(...data.tracks[0].t);
const viewers = [];  // functions of a time
let now = null;
let pinned = false;

function show(t) {
    now = Math.min(Math.max(t, 0), duration);
    document.body.dataset.t = now.toFixed(3);
    for (const view of viewers) view(now);
}

function hover(t) {
    show(pinned ? now : t);
}

function remember(fragment) {
    history.replaceState(null, '', location.href.split('#')[0] + fragment);
}

function pin(t) {
    pinned = true;
    document.body.classList.add('pinned');
    show(t);
    remember('#t=' + now.toFixed(3).replace(/\.?0+$/, ''));
}

function unpin() {
    pinned = false;
    document.body.classList.remove('pinned');
    remember('');
}

function click(t) {
    if (pinned) unpin(); else pin(t);
    show(pinned ? now : t);
}
