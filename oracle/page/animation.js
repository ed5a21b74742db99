'use strict';

// The journal in its bearing, frame by frame; what the data mean is said in animation_data.cpp.
(() => {
  const data = page.embedded('motion-data');
  if (!data || !data.runs.length) return;
  const bearing = page.element('motion-bearing');
  const machine = page.element('motion-mechanism');
  const runList = page.element('motion-run');
  const scaleList = page.element('motion-scale');
  const {int8s, int16s, floats, circle, arrow} = page;
  const bore = 100, journalRadius = 64, clearance = bore - journalRadius, tallest = 56;

  function unpacked(run) {
    const force = floats(run.force);
    const sizes = Array.from({length: run.frames}, (_, i) => Math.hypot(force[2 * i], force[2 * i + 1]));
    return {...run, force, e: int16s(run.eccentricity), attitude: int16s(run.attitude), film: floats(run.film),
      peak: floats(run.peak), pressure: int8s(run.pressure),
      parts: run.mechanism ? floats(run.mechanism) : null, mostForce: Math.max(...sizes)};
  }

  data.runs.forEach((run, i) => page.add(runList, 'option', {value: i}, run.name));
  let run;
  const cache = new Map();

  // What changes from frame to frame.
  let parts = {};

  function build() {
    bearing.replaceChildren();
    parts = {
      pressure: page.add(bearing, 'path', {class: 'pressure'}),
      suction: page.add(bearing, 'path', {class: 'suction'}),
    };
    page.add(bearing, 'circle', {class: 'bearing', r: bore + 8});
    page.add(bearing, 'circle', {class: 'film', r: bore});
    Object.assign(parts, {
      hole: page.add(bearing, 'path', {class: 'mark'}),
      journal: page.add(bearing, 'circle', {class: 'journal', r: journalRadius}),
      mark: page.add(bearing, 'path', {class: 'mark'}),
    });
    page.add(bearing, 'path', {class: 'clearance', d: circle(0, 0, clearance)});
    const orbit = Array.from({length: run.frames}, (_, i) => `${clearance * run.e[2 * i]},${-clearance * run.e[2 * i + 1]}`);
    page.add(bearing, 'path', {class: 'orbit', d: 'M' + orbit.join('L')});
    Object.assign(parts, {
      trail: page.add(bearing, 'path', {class: 'trail'}),
      load: page.add(bearing, 'path', {class: 'load'}),
      force: page.add(bearing, 'path', {class: 'arrow'}),
      centre: page.add(bearing, 'circle', {class: 'centre', r: 2.6}),
      orbit,
    });
    page.element('motion-load-key').hidden = !run.load;

    machine.replaceChildren();
    machine.toggleAttribute('hidden', !run.parts);
    if (run.parts) {
      const reach = 1e3 * (run.crank_length + run.rod_length);
      page.add(machine, 'path', {class: 'ground', d: `M40,14H${reach + 25}M40,-14H${reach + 25}M-60,0H${reach + 25}`,
        'stroke-dasharray': '1 0'});
      page.add(machine, 'path', {class: 'clearance', d: circle(0, 0, 1e3 * run.crank_length)});
      parts.slider = page.add(machine, 'rect', {class: 'journal', y: -13, width: 36, height: 26});
      parts.rod = page.add(machine, 'path', {class: 'link'});
      parts.crank = page.add(machine, 'path', {class: 'link'});
      parts.pin = page.add(machine, 'circle', {class: 'arrow', r: 3.5});
      page.add(machine, 'circle', {class: 'centre', r: 3});
    }

    parts.numbers = page.numbers('motion-numbers', {time: run.parts ? 'time, crank angle' : 'time', ratio: 'ε = e/c',
      film: 'least film', force: 'force on the journal', peak: 'largest pressure'});
    page.element('motion-law').textContent = run.words;
  }

  function drawPressure(frame, relative) {
    const n = data.nodes;
    const low = Math.min(Math.floor(frame), run.frames - 1);
    const thinnest = run.film[low] / run.clearance;  // 1 − ε
    const stretch = Math.sqrt((2 - thinnest) / thinnest);
    const ring = {pressure: [], suction: []};
    for (let i = 0; i <= n; ++i) {
      const p = run.pressure[n * low + i % n] * relative;
      const theta = 2 * Math.atan2(stretch * Math.sin(Math.PI * i / n), Math.cos(Math.PI * i / n));
      const angle = Math.PI * (run.attitude[low] + 1) + theta;  // the film at θ lies opposite to e turned by θ
      const at = (radius) => `${(radius * Math.cos(angle)).toFixed(1)},${(-radius * Math.sin(angle)).toFixed(1)}`;
      ring.pressure.push(at(bore + 8 + tallest * Math.max(p, 0)));
      ring.suction.push(at(bore + 8 + tallest * Math.max(-p, 0)));
    }
    const signs = run.pressure.slice(n * low, n * low + n);
    for (const [kind, there] of [['pressure', signs.some((p) => p > 0)], ['suction', signs.some((p) => p < 0)]]) {
      parts[kind].setAttribute('d', there ? `M${ring[kind].join('L')}z` : '');
    }
  }

  function draw(frame) {
    const between = (list, width, index) => page.between(list, width, index, frame);
    const [ex, ey] = [between(run.e, 2, 0), between(run.e, 2, 1)];
    const [fx, fy] = [between(run.force, 2, 0), between(run.force, 2, 1)];
    const [x, y] = [clearance * ex, -clearance * ey];
    const seconds = run.end * frame / Math.max(run.frames - 1, 1);
    const ofRun = scaleList.value === 'run';
    const peak = run.peak[Math.min(Math.floor(frame), run.frames - 1)];
    const mostPressure = Math.max(...run.peak);
    drawPressure(frame, ofRun ? (mostPressure > 0 ? peak / mostPressure : 0) : 1);

    parts.journal.setAttribute('cx', x);
    parts.journal.setAttribute('cy', y);
    parts.centre.setAttribute('cx', x);
    parts.centre.setAttribute('cy', y);
    const turn = run.parts ? 0 : run.journal_spin * seconds;
    const spoke = (radius) => `${x + radius * Math.cos(turn)},${y - radius * Math.sin(turn)}`;
    parts.mark.setAttribute('d', `M${spoke(journalRadius - 9)}L${spoke(journalRadius)}`);
    const rod = run.parts ? between(run.parts, 3, 1) : Math.PI / 2;
    const hole = (radius) => `${radius * Math.cos(rod)},${-radius * Math.sin(rod)}`;
    parts.hole.setAttribute('d', `M${hole(bore)}L${hole(bore + 8)}`);
    parts.trail.setAttribute('d', `M${[...parts.orbit.slice(0, Math.floor(frame) + 1), `${x},${y}`].join('L')}`);
    const size = Math.hypot(fx, fy);
    const unit = 60 / (ofRun ? run.mostForce : size || 1);
    parts.force.setAttribute('d', arrow(x, y, unit * fx, -unit * fy));
    parts.load.setAttribute('d', run.load ? arrow(x, y, unit * run.load[0], -unit * run.load[1]) : '');

    if (run.parts) {
      const crank = between(run.parts, 3, 0);
      const [px, py] = [1e3 * run.crank_length * Math.cos(crank), -1e3 * run.crank_length * Math.sin(crank)];
      const [sx, rx, ry] = [1e3 * between(run.parts, 3, 2), px + 1e3 * run.rod_length * Math.cos(rod),
        py - 1e3 * run.rod_length * Math.sin(rod)];
      parts.crank.setAttribute('d', `M0,0L${px},${py}`);
      parts.rod.setAttribute('d', `M${px},${py}L${rx},${ry}`);
      parts.slider.setAttribute('x', sx - 18);
      parts.pin.setAttribute('cx', sx);
      parts.pin.setAttribute('cy', 0);
      parts.numbers.time.textContent = `${(1e3 * seconds).toFixed(2)} ms, ${(180 / Math.PI * crank).toFixed(0)}°`;
    } else {
      parts.numbers.time.textContent = `${(1e3 * seconds).toFixed(0)} ms`;
    }
    const film = between(run.film, 1, 0);
    const ratio = 1 - film / run.clearance;
    parts.numbers.ratio.textContent = ratio.toFixed(4);
    parts.numbers.film.textContent = `${+(1e6 * film).toPrecision(3)} µm`;
    parts.numbers.force.textContent = `${+size.toPrecision(4)} N`;
    parts.numbers.peak.textContent = `${+(1e-6 * peak).toPrecision(3)} MPa`;
    return `${parts.numbers.time.textContent}, ε ${ratio.toFixed(3)}`;
  }

  const player = page.player('motion', draw);
  function select(index) {
    if (!cache.has(index)) cache.set(index, unpacked(data.runs[index]));
    run = cache.get(index);
    build();
    player.show(run.frames, 0.06);  // a first picture that shows something: the journal on its way
  }

  scaleList.addEventListener('change', player.redraw);
  runList.addEventListener('change', () => select(+runList.value));
  const spiral = data.runs.findIndex((item) => item.law === 'pinkus_sternlicht');
  runList.value = Math.max(spiral, 0);
  select(+runList.value);
})();
