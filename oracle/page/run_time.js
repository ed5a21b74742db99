'use strict';

// Error against run time: marks and lines from the embedded CSV; toggles, logarithmic axes, numbers at a mark.
(() => {
  const csv = page.embedded('csv-run-time');
  if (csv === null) return;
  const rows = page.csvRows(csv);
  const svg = page.element('run-time-plot');
  const tip = page.element('run-time-tip');
  const readout = page.element('run-time-readout');
  const sceneList = page.element('run-time-scene');
  const logX = page.element('run-time-log-x');
  const logY = page.element('run-time-log-y');
  const integrators = [...new Set(rows.map((row) => row.integrator))];
  const hidden = new Set();
  let points = [];
  let current = -1;

  // No two integrators share both colour and shape, for up to 56 of them.
  const colours = ['blue', 'vermillion', 'green', 'purple', 'orange', 'sky', 'text'];
  const shapes = [
    'M-5,0a5,5 0 1,0 10,0a5,5 0 1,0 -10,0z', 'M-4.5,-4.5h9v9h-9z', 'M0,-6L5.5,4.5H-5.5z', 'M0,-6.5L5.5,0L0,6.5L-5.5,0z',
    'M0,6L5.5,-4.5H-5.5z', 'M-6,-2h4v-4h4v4h4v4h-4v4h-4v-4h-4z',
    'M0,-6L1.8,-1.9L6,-1.9L2.7,1.1L3.8,5.5L0,3L-3.8,5.5L-2.7,1.1L-6,-1.9L-1.8,-1.9z', 'M-5,-3L0,-6L5,-3V3L0,6L-5,3z'];
  const look = (integrator) => {
    const i = integrators.indexOf(integrator);
    // Lines have no mark between two points: those of a colour that is there already are broken.
    const dashes = ['', '7 3', '2 3', '8 3 2 3'][Math.floor(i / colours.length) % 4];
    return {d: shapes[i % shapes.length], style: `fill:var(--${colours[i % colours.length]})`, dashes};
  };

  const usable = (row) => row.status === 'finished' && row.error !== '' && Number.isFinite(+row.error);
  // A journal of its own has but one formulation.
  const key = (row) => row.scene + (row.formulation === 'journal' ? '' : `, ${row.formulation} coordinates`);
  for (const name of new Set(rows.map(key))) page.add(sceneList, 'option', {value: name}, name);

  for (const integrator of integrators) {
    const label = page.add(page.element('run-time-integrators'), 'label');
    const box = page.add(label, 'input', {type: 'checkbox', value: integrator});
    box.checked = true;
    const sample = page.add(label, 'svg', {viewBox: '-8 -8 16 16', 'aria-hidden': 'true'});
    const {d, style} = look(integrator);
    page.add(sample, 'path', {d, style});
    label.append(integrator);
    box.addEventListener('change', () => {
      if (box.checked) hidden.delete(integrator);
      else hidden.add(integrator);
      draw();
    });
  }

  /** Ends and ticks of an axis: whole decades, or from zero in round steps. */
  function axis(values, logarithmic, length) {
    if (logarithmic) {
      let low = Math.floor(Math.log10(Math.min(...values)) + 1e-9);
      let high = Math.ceil(Math.log10(Math.max(...values)) - 1e-9);
      if (low >= high) [low, high] = [low - 1, low + 1];
      const step = Math.ceil((high - low) / (length / 55));
      const ticks = [];
      for (let exponent = low; exponent <= high; exponent += step) ticks.push(10 ** exponent);
      return {ticks, at: (value) => (Math.log10(value) - low) / (high - low)};
    }
    const top = Math.max(...values);
    const raw = top / (length / 80);
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = power * [1, 2, 5, 10].find((factor) => factor * power >= raw);
    const ticks = [];
    for (let i = 0; (i - 1) * step < top; ++i) ticks.push(i * step);
    const end = ticks[ticks.length - 1];
    return {ticks, at: (value) => value / end};
  }

  /** A tick's words: 10⁻³ on logarithmic axes, 0.003 on others. */
  function tickWords(value, logarithmic) {
    if (!logarithmic) return String(+value.toPrecision(3));
    const exponent = Math.round(Math.log10(value));
    return '10' + [...String(exponent)].map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[+c])).join('');
  }

  const number = (text, digits = 3) => (text === '' ? 'not counted' : String(+(+text).toPrecision(digits)));

  function words(row) {
    return `${row.integrator}, tolerance ${row.tolerance}\nerror ${number(row.error)} c\n` +
      `time ${number(1e3 * row.seconds)} ms\nsteps ${row.steps}, rejected ${row.rejected}\n` +
      `evaluations ${row.rhs_evaluations}, Jacobians ${row.jacobian_evaluations}, ` +
      `factorisations ${row.factorisations}`;
  }

  function draw() {
    const width = page.clamp(svg.parentElement.clientWidth || 700, 280, 900);
    const height = width < 520 ? 340 : 460;
    const left = 58, right = width - 12, top = 12, bottom = height - 46;
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    svg.replaceChildren();
    choose(-1);

    const ofScene = rows.filter((row) => key(row) === sceneList.value);
    const finished = ofScene.filter(usable);
    const fits = (row) => (!logX.checked || +row.seconds > 0) && (!logY.checked || +row.error > 0);
    const drawn = finished.filter(fits);
    // Axes stay put when an integrator is hidden: the others do not jump.
    const x = axis(drawn.length ? drawn.map((row) => 1e3 * row.seconds) : [1, 10], logX.checked, right - left);
    const y = axis(drawn.length ? drawn.map((row) => +row.error) : [1e-9, 1], logY.checked, bottom - top);
    const atX = (value) => left + (right - left) * x.at(value);
    const atY = (value) => bottom - (bottom - top) * y.at(value);

    for (const tick of x.ticks) {
      page.add(svg, 'path', {class: 'rule', d: `M${atX(tick)},${top}V${bottom}`});
      page.add(svg, 'text', {x: atX(tick), y: bottom + 17, 'text-anchor': 'middle'}, tickWords(tick, logX.checked));
    }
    for (const tick of y.ticks) {
      page.add(svg, 'path', {class: 'rule', d: `M${left},${atY(tick)}H${right}`});
      page.add(svg, 'text', {x: left - 6, y: atY(tick) + 4, 'text-anchor': 'end'}, tickWords(tick, logY.checked));
    }
    page.add(svg, 'path', {class: 'frame', d: `M${left},${top}V${bottom}H${right}`});
    page.add(svg, 'text', {x: (left + right) / 2, y: height - 8, 'text-anchor': 'middle'}, 'run time t [ms]');
    page.add(svg, 'text', {transform: `translate(13 ${(top + bottom) / 2}) rotate(-90)`, 'text-anchor': 'middle'},
      'largest error |Δe|/c [-]');

    points = [];
    for (const integrator of integrators) {
      if (hidden.has(integrator)) continue;
      const own = drawn.filter((row) => row.integrator === integrator).sort((a, b) => b.tolerance - a.tolerance);
      if (!own.length) continue;
      const group = page.add(svg, 'g', {'data-integrator': integrator});
      const places = own.map((row) => [atX(1e3 * row.seconds), atY(+row.error)]);
      const {d, style, dashes} = look(integrator);
      page.add(group, 'path', {d: 'M' + places.map((place) => place.join(',')).join('L'), 'stroke-dasharray': dashes,
        style: style.replace('fill', 'stroke') + ';fill:none;stroke-width:1.2'});
      own.forEach((row, i) => {
        const mark = page.add(group, 'path', {class: 'mark', d, style, transform: `translate(${places[i].join(' ')})`});
        points.push({row, mark, x: places[i][0], y: places[i][1]});
      });
    }

    const missing = ofScene.filter((row) => !usable(row)).map((row) => `${row.integrator} at ${row.tolerance}`);
    const zero = finished.length - drawn.length;
    page.element('run-time-missing').textContent = (missing.length ? `Stopped: ${missing.join(', ')}. ` : '') +
      (zero ? `Not on logarithmic axes, as zero: ${zero}.` : '');
  }

  /** Shows the numbers of a point; -1: of none. */
  function choose(index) {
    points[current]?.mark.removeAttribute('stroke');
    current = index;
    const point = points[index];
    tip.hidden = !point;
    if (!point) return;
    point.mark.setAttribute('stroke', 'currentColor');
    tip.textContent = words(point.row);
    readout.textContent = words(point.row).replaceAll('\n', '; ') + '.';
    const scale = svg.clientWidth / svg.viewBox.baseVal.width || 1;
    const flip = point.x * scale > svg.clientWidth / 2;
    tip.style.left = flip ? '' : `${point.x * scale + 12}px`;
    tip.style.right = flip ? `${svg.clientWidth - point.x * scale + 12}px` : '';
    tip.style.top = `${Math.max(0, point.y * scale - 30)}px`;
  }

  function nearest(event) {
    const box = svg.getBoundingClientRect();
    const scale = svg.viewBox.baseVal.width / box.width;
    const x = (event.clientX - box.left) * scale;
    const y = (event.clientY - box.top) * scale;
    let best = -1, distance = 24;
    points.forEach((point, i) => {
      const away = Math.hypot(point.x - x, point.y - y);
      if (away < distance) [best, distance] = [i, away];
    });
    return best;
  }

  svg.addEventListener('pointermove', (event) => choose(nearest(event)));
  svg.addEventListener('pointerdown', (event) => choose(nearest(event)));
  svg.addEventListener('pointerleave', () => choose(-1));
  svg.addEventListener('blur', () => choose(-1));
  svg.addEventListener('keydown', (event) => {
    const steps = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1};
    if (event.key === 'Escape') choose(-1);
    if (!(event.key in steps) || !points.length) return;
    event.preventDefault();
    const start = current < 0 && steps[event.key] < 0 ? 0 : current;
    choose((start + steps[event.key] + points.length) % points.length);
  });
  for (const control of [sceneList, logX, logY]) control.addEventListener('change', draw);
  let drawnWidth = 0;
  new ResizeObserver(() => {
    if (svg.parentElement.clientWidth === drawnWidth) return;
    drawnWidth = svg.parentElement.clientWidth;
    draw();
  }).observe(svg.parentElement);
  draw();
})();
