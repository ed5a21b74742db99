'use strict';

// Uses the report as a person does, in a browser, and hands the failures to the page around it (page_in_browser.sh).
(async () => {
  const failures = [];
  let checks = 0;
  const check = (good, words) => {
    ++checks;
    if (!good) failures.push(words);
  };
  const element = (id) => document.getElementById(id);
  const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
  const change = (control, value) => {
    if (control.type === 'checkbox') control.checked = value;
    else control.value = value;
    control.dispatchEvent(new Event(control.type === 'range' ? 'input' : 'change', {bubbles: true}));
  };
  const shown = (node) => node.getBoundingClientRect().width > 0 && node.getBoundingClientRect().height > 0;

  /** Contrast of two colours after the Web Content Accessibility Guidelines, 1 to 21. */
  function contrast(one, other) {
    const [light, dark] = [one, other].map((colour) => {
      const [r, g, b] = colour.match(/[\d.]+/g).slice(0, 3).map((part) => {
        const c = part / 255;
        return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
      });
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    }).sort((a, b) => b - a);
    return (light + 0.05) / (dark + 0.05);
  }

  function drawings() {
    for (const details of document.querySelectorAll('details')) details.open = true;
    const panels = [...document.querySelectorAll('figure.panel svg')];
    check(panels.length >= 50, `only ${panels.length} panels`);
    const ground = getComputedStyle(document.body).backgroundColor;
    for (const svg of panels) {
      const id = svg.parentElement.id;
      check(shown(svg), `${id} has no size`);
      const lines = [...svg.querySelectorAll('path, polygon')].filter((line) => {
        const box = line.getBBox();
        return box.width > 100 || box.height > 100;
      });
      check(lines.length >= 2, `${id} draws nothing`);
      const texts = [...svg.querySelectorAll('text')];
      check(texts.length > 4, `${id} has no labels`);
      check(texts.some((text) => /\[.+\]/.test(text.textContent)), `${id} has an axis without a unit`);
      for (const text of texts) {
        if (!text.textContent.trim()) continue;
        check(contrast(getComputedStyle(text).fill, ground) >= 4.5, `${id}: "${text.textContent}" is pale`);
        check(text.getBoundingClientRect().height >= 7.5, `${id}: "${text.textContent}" is tiny`);
      }
    }
    const curve = document.querySelector('#figure-9a path[stroke="var(--blue)"]');
    check(curve && contrast(getComputedStyle(curve).stroke, ground) >= 3, 'a curve is pale');
    for (const words of document.querySelectorAll('h1, h2, p, li, td, th, caption, figcaption, a, dd, dt')) {
      if (!words.textContent.trim() || words.closest('.map td, .swatch')) continue;
      const under = words.closest('.note, .verdict, nav') || document.body;
      const behind = getComputedStyle(under).backgroundColor;
      const against = behind === 'rgba(0, 0, 0, 0)' ? ground : behind;
      check(contrast(getComputedStyle(words).color, against) >= 4.5, `"${words.textContent.slice(0, 40)}" is pale`);
    }
    for (const cell of document.querySelectorAll('.map td[class^="level-"]')) {
      const colours = getComputedStyle(cell);
      if (cell.className !== 'level-stop' && cell.className !== 'level-none') {
        check(contrast(colours.color, colours.backgroundColor) >= 4.5, `a cell of ${cell.className} is pale`);
      }
    }
    const wide = [...document.querySelectorAll('body *')].filter((node) =>
      node.getBoundingClientRect().right > innerWidth + 0.5 && !node.closest('.scroll, pre, svg'));
    check(document.documentElement.scrollWidth <= innerWidth,
      `wider than the window: ${wide.slice(0, 3).map((node) => node.outerHTML.slice(0, 60)).join(' and ')}`);
  }

  async function tables() {
    for (const details of document.querySelectorAll('details')) details.open = true;
    await wait(200);  // the hints follow the boxes' sizes
    const narrow = innerWidth < 640;
    for (const box of document.querySelectorAll('.scroll')) {
      const name = box.getAttribute('aria-label');
      const cut = box.scrollWidth > box.clientWidth + 1;
      const hint = getComputedStyle(box, '::before').content;
      check(box.classList.contains('cut') === cut && /goes on/.test(hint) === cut, `${name}: the hint is wrong`);
      if (innerWidth >= 1280 || box.classList.contains('cards')) check(!cut, `${name}: the table is cut`);
    }
    const cards = [...document.querySelectorAll('.cards tbody tr')];
    check(cards.length > 30, `only ${cards.length} rows of words`);
    for (const row of cards) {
      check((getComputedStyle(row).display === 'block') === narrow, 'a row is no card on a phone, or one elsewhere');
      const cell = row.querySelector('td');
      const head = getComputedStyle(cell, '::before').content;
      check(narrow ? head.includes(cell.dataset.head) : head === 'none', `a card's cell says ${head}`);
    }
    for (const panel of document.querySelectorAll('.panel:only-child')) {
      const text = panel.closest('article').querySelector('.words').getBoundingClientRect().width;
      check(Math.abs(panel.getBoundingClientRect().width - text) < 2, `${panel.id} is not as wide as the text`);
    }
  }

  function saving() {
    // A blob is read in another thread, which virtual time does not wait for: keep what it is made of.
    const made = [];
    const original = window.Blob;
    window.Blob = class extends original {
      constructor(pieces, options) {
        super(pieces, options);
        made.push(pieces.join(''));
      }
    };
    const buttons = [...document.querySelectorAll('button[data-csv]')];
    check(buttons.length >= 6, `only ${buttons.length} files to save`);
    for (const button of buttons) {
      button.click();
      const text = made.pop() ?? '';
      const carried = JSON.parse(element(button.dataset.csv).textContent);
      check(text === carried && text.split('\n').length > 2, `${button.dataset.file} is not saved as it is`);
    }
    window.Blob = original;
  }

  function runTimes() {
    const [header, ...lines] = JSON.parse(element('csv-run-time').textContent).trim().split('\n').map((l) => l.split(','));
    const rows = lines.map((fields) => Object.fromEntries(header.map((name, i) => [name, fields[i]])));
    const svg = element('run-time-plot');
    const marks = () => [...svg.querySelectorAll('.mark')];
    const labels = () => [...svg.querySelectorAll('text')].map((text) => text.textContent).join(' ');
    const scenes = [...element('run-time-scene').options].map((option) => option.value);
    check(scenes.length === new Set(rows.map((row) => row.scene + row.formulation)).size, 'scenes are missing');
    for (const scene of scenes) {
      change(element('run-time-scene'), scene);
      const own = rows.filter((row) => scene === (row.formulation === 'journal' ? row.scene :
        `${row.scene}, ${row.formulation} coordinates`));
      const finished = own.filter((row) => row.status === 'finished');
      check(marks().length === finished.length, `${scene}: ${marks().length} marks for ${finished.length} runs`);
      const stopped = element('run-time-missing').textContent.includes('Stopped');
      check(stopped === own.length > finished.length, `${scene}: stopped runs are not told`);
    }
    change(element('run-time-scene'), scenes[0]);

    const all = marks().length;
    const boxes = [...element('run-time-integrators').querySelectorAll('input')];
    check(boxes.length === new Set(rows.map((row) => row.integrator)).size, 'a toggle is missing');
    for (const box of boxes) {
      change(box, false);
      const gone = !svg.querySelector(`[data-integrator="${box.value}"]`) && marks().length < all;
      check(gone, `${box.value} does not go`);
      change(box, true);
      check(marks().length === all, `${box.value} does not come back`);
    }
    const looks = marks().map((mark) => mark.parentElement.dataset.integrator + mark.getAttribute('d') + mark.getAttribute('style'));
    check(new Set(looks).size === boxes.length, 'two integrators look the same');
    const strokes = [...svg.querySelectorAll('[data-integrator] > path:not(.mark)')].map((line) =>
      line.getAttribute('style') + line.getAttribute('stroke-dasharray'));
    check(new Set(strokes).size === boxes.length, 'two integrators have the same line');

    check(/run time t \[ms\]/.test(labels()) && /\[-\]/.test(labels()), 'an axis has no unit');
    check(/10⁻/.test(labels()), 'the logarithmic axes have no powers of ten');
    const before = marks().map((mark) => mark.getAttribute('transform')).join();
    change(element('run-time-log-x'), false);
    const between = marks().map((mark) => mark.getAttribute('transform')).join();
    check(between !== before, 'the time axis stays logarithmic');
    change(element('run-time-log-y'), false);
    check(!/10⁻/.test(labels()) && marks().length === all, 'the error axis stays logarithmic');
    change(element('run-time-log-x'), true);
    change(element('run-time-log-y'), true);
    check(marks().map((mark) => mark.getAttribute('transform')).join() === before, 'the axes do not come back');

    const tip = element('run-time-tip');
    svg.scrollIntoView({block: 'center'});
    let told = 0;
    for (const mark of marks()) {
      const box = mark.getBoundingClientRect();
      const place = {clientX: box.x + box.width / 2, clientY: box.y + box.height / 2, bubbles: true};
      svg.dispatchEvent(new PointerEvent('pointermove', place));
      const words = tip.textContent;
      const row = rows.find((r) => words.startsWith(`${r.integrator}, tolerance ${r.tolerance}\n`) &&
        words.includes(`error ${+(+r.error).toPrecision(3)} c`) &&
        words.includes(`time ${+(1e3 * r.seconds).toPrecision(3)} ms`) && words.includes(`steps ${r.steps},`));
      told += !tip.hidden && Boolean(row);
    }
    check(told === all, `numbers at ${told} of ${all} marks`);
    const edge = tip.getBoundingClientRect();
    check(edge.left >= 0 && edge.right <= innerWidth, 'the numbers are outside of the window');
    svg.dispatchEvent(new PointerEvent('pointerleave'));
    check(tip.hidden, 'the numbers do not go');
    const seen = new Set();
    for (let i = 0; i < all; ++i) {
      svg.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', cancelable: true}));
      seen.add(element('run-time-readout').textContent);
    }
    check(seen.size === all, `the arrow keys reach ${seen.size} of ${all} marks`);
    svg.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}));
    check(tip.hidden, 'Escape does not hide the numbers');
  }

  function stability() {
    const cells = [...document.querySelectorAll('#stability-maps td[title]')];
    check(cells.length > 100, `only ${cells.length} cells of the stability maps`);
    for (const cell of cells) {
      cell.dispatchEvent(new PointerEvent('pointerover', {bubbles: true}));
      const words = element('stability-readout').textContent;
      check(words.includes(cell.title) && words.includes(cell.parentElement.cells[0].textContent),
        `a cell does not say what it is: ${words}`);
    }
  }

  /**
   * Plays an animation and stops it.
   * @param picture  what changes from frame to frame
   * @param others  its controls beside those of every animation
   */
  async function plays(name, picture, others) {
    // Virtual time has no regular frames.
    window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);
    const play = element(`${name}-play`);
    const slider = element(`${name}-time`);
    const stage = slider.closest('section').querySelector('.stage');
    const numbers = () => element(`${name}-numbers`).textContent;
    change(slider, 0);
    const pictures = new Set();
    const watch = new MutationObserver(() => pictures.add(picture()));
    watch.observe(stage, {attributes: true, subtree: true});
    play.click();
    check(play.textContent === 'Pause', 'Play does not become Pause');
    await wait(1100);
    play.click();
    watch.disconnect();
    const less = matchMedia('(prefers-reduced-motion: reduce)').matches;
    check(pictures.size > 1, `${name} does not play`);
    check(less ? pictures.size <= 5 : pictures.size > 8, `${pictures.size} pictures in a second`);
    check(play.textContent === 'Play', 'Pause does not become Play');
    const stopped = numbers();
    await wait(200);
    check(numbers() === stopped, `${name} plays on after Pause`);
    for (const control of [play, slider, ...['speed', ...others].map((part) => element(`${name}-${part}`))]) {
      control.focus();
      check(document.activeElement === control, `${control.id} is not reached by the keyboard`);
    }
  }

  async function motion() {
    const bearing = element('motion-bearing');
    const machine = element('motion-mechanism');
    const slider = element('motion-time');
    const numbers = () => element('motion-numbers').textContent;
    const runs = [...element('motion-run').options];
    check(runs.length === 13, `${runs.length} runs in place of 8 and 5`);
    for (const option of runs) {
      change(element('motion-run'), option.value);
      const name = option.textContent;
      check(machine.hasAttribute('hidden') === !name.startsWith('Slider'), `${name}: the mechanism`);
      const states = new Set();
      for (const share of [0.1, 0.3, 0.5, 0.9]) {
        change(slider, Math.round(slider.max * share));
        states.add(numbers());
        const journal = bearing.querySelector('.journal');
        check(Math.hypot(journal.getAttribute('cx'), journal.getAttribute('cy')) <= 36.01, `${name}: outside of the bearing`);
        check(bearing.querySelector('.pressure').getAttribute('d').length > 100, `${name}: no pressure`);
        const sucks = bearing.querySelector('.suction').getAttribute('d').length > 100;
        if (/ full film/.test(name)) check(sucks, `${name}: no pressure below the surroundings'`);
        if (/dynamic|Pinkus|Slider/.test(name)) check(!sucks, `${name}: pressure below the surroundings'`);
      }
      check(states.size === 4, `${name}: the slider does not move it`);
      check(!/NaN|undefined|Infinity/.test(bearing.outerHTML + machine.outerHTML + numbers()), `${name}: no number`);
    }
    const arrow = () => bearing.querySelector('.arrow').getAttribute('d');
    const drawn = arrow();
    change(element('motion-scale'), 'instant');
    check(arrow() !== drawn, 'the scale does not change');
    change(element('motion-scale'), 'run');

    await plays('motion', () => bearing.querySelector('.trail').getAttribute('d'), ['run']);
  }

  async function space() {
    const machine = element('space-mechanism');
    const orbit = element('space-orbit');
    const slider = element('space-time');
    const path = (svg, look) => svg.querySelector(`.${look}`).getAttribute('d');
    const states = new Set();
    const end = JSON.parse(element('space-data').textContent).end;
    for (const share of [0, 0.2, 0.5, 0.8, 1]) {
      change(slider, Math.round(slider.max * share));
      states.add(path(machine, 'link') + element('space-numbers').textContent);
      const point = orbit.querySelector('.centre');
      const ratio = Math.hypot(point.getAttribute('cx'), point.getAttribute('cy')) / 100;
      const row = (words) => [...element('space-numbers').children].find((each) => each.textContent.startsWith(words));
      const number = (words) => parseFloat(row(words).querySelector('dd').textContent);
      check(Math.abs(ratio - number('ε')) < 1e-3 && ratio < 1, `drawn at ε = ${ratio}, told is ${number('ε')}`);
      const seconds = end * slider.value / slider.max;
      check(Math.abs(number('time') - seconds) < 1e-3, `${number('time')} s in place of ${seconds}`);
      // Crank pin and rod meet.
      const ends = path(machine, 'link').split('M').slice(1).map((line) => line.split('L')[1].split(',').map(Number));
      const [crank, rod, tip] = ends;
      check(Math.hypot(crank[0] - rod[0], crank[1] - rod[1]) < 0.1, `the rod is not at the crank: ${crank} and ${rod}`);
      // The rod's other end is in the middle of the pin.
      const [one, other] = path(machine, 'pin').slice(1).split('L').map((point) => point.split(',').map(Number));
      const middle = one.map((value, k) => (value + other[k]) / 2);
      check(Math.hypot(middle[0] - tip[0], middle[1] - tip[1]) < 0.1, 'the pin is off the rod');
      const slides = machine.querySelector('.journal').getBBox();
      check(Math.hypot(slides.x + slides.width / 2 - tip[0], slides.y + slides.height / 2 - tip[1]) < 1,
        'the slider is off the pin');
      const [, , width, height] = machine.getAttribute('viewBox').split(' ').map(Number);
      const box = machine.querySelector('.link').getBBox();
      const [right, bottom] = [box.x + box.width, box.y + box.height];
      check(Math.max(-box.x, right) < width / 2 && Math.max(-box.y, bottom) < height / 2, 'the links leave the drawing');
    }
    let longest = 0;
    for (let i = 0; i <= +slider.max; ++i) {
      change(slider, i);
      const arrow = path(orbit, 'arrow').match(/-?[\d.]+(e-\d+)?/g)?.slice(0, 4).map(Number) ?? [0, 0, 0, 0];
      longest = Math.max(longest, Math.hypot(arrow[2] - arrow[0], arrow[3] - arrow[1]));
    }
    check(Math.abs(longest - 60) < 0.1, `the longest arrow is ${longest}`);
    check(states.size === 5, 'the slider does not move it');
    check(path(orbit, 'orbit').split('L').length === +slider.max + 1, 'the orbit is not that of all frames');
    const lines = [...machine.querySelectorAll('path')];
    check(lines.every((line) => line.getAttribute('d').length > 20), 'something is not drawn');
    for (const angle of [-180, -90, 0, 90]) {
      const before = path(machine, 'link') + path(machine, 'orbit');
      change(element('space-view'), angle);
      check(path(machine, 'link') + path(machine, 'orbit') !== before, 'the view does not turn');
    }
    check(!/NaN|undefined|Infinity/.test(machine.outerHTML + orbit.outerHTML), 'no number');
    check([...element('space').querySelectorAll('.checked')].length === 1, 'nothing is said to be checked');
    await plays('space', () => path(machine, 'link'), ['view']);
  }

  function printing() {
    for (const details of document.querySelectorAll('details')) details.open = false;
    dispatchEvent(new Event('beforeprint'));
    check(!document.querySelector('details:not([open])'), 'something stays folded on paper');
    dispatchEvent(new Event('afterprint'));
    check(!document.querySelector('details[open]'), 'something stays unfolded after printing');
  }

  for (const part of [drawings, tables, saving, runTimes, stability, motion, space, printing]) {
    try {
      await part();
    } catch (error) {
      failures.push(`${part.name}: ${error.stack}`);
    }
  }
  failures.push(...window.complaints.map((words) => `console: ${words}`));
  const settings = `${innerWidth} px, ${matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'}`;
  parent.postMessage({settings, checks, failures}, '*');
})();
