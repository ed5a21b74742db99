'use strict';

// The slider-crank in space and its journal, frame by frame; what the data mean is said in space_section.cpp.
(() => {
  const data = page.embedded('space-data');
  if (!data) return;
  const machine = page.element('space-mechanism');
  const orbit = page.element('space-orbit');
  const view = page.element('space-view');
  const elevation = 25 * Math.PI / 180;
  const wall = 100, longest = 60;  // of the clearance circle and the force's arrow
  const block = [18, 13, 13];  // half edges of a body that has no arms [mm]
  const e = page.int16s(data.eccentricity);
  const force = page.floats(data.force);
  const film = page.floats(data.film);
  const bodies = data.bodies.map((body) => ({...body, position: page.floats(body.position), turn: page.int16s(body.turn)}));
  const mostForce = Math.max(...film.map((_, i) => Math.hypot(force[2 * i], force[2 * i + 1])));

  // Vectors in millimetres, inertial.
  const scaled = (v) => v.map((x) => 1e3 * x);
  const sum = (a, b) => a.map((x, i) => x + b[i]);
  const dot = (a, b) => a.reduce((total, x, i) => total + x * b[i], 0);

  /** A body's place and its axes at a frame. */
  function placed(body, frame) {
    const p = [0, 1, 2, 3].map((k) => page.between(body.turn, 4, k, frame));
    const size = Math.hypot(...p);
    const [w, x, y, z] = p.map((value) => value / size);
    const rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
      [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
      [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]];
    const place = scaled([0, 1, 2].map((k) => page.between(body.position, 3, k, frame)));
    const turned = (v) => rows.map((row) => dot(row, v));
    return {place, turned, at: (point) => sum(place, turned(scaled(point)))};
  }

  /** Lines from the mass centre of a body to the ends of its arms. */
  const lines = (body, at) => body.arms.map((arm) => [at.place, at.at(arm)]);

  // The box that the motion fills, of its arms and of what does not move.
  const everything = [[0, 0, 0], ...data.axes.flat().map(scaled)];
  for (const body of bodies) {
    for (let i = 0; i < data.frames; ++i) everything.push(...lines(body, placed(body, i)).flat());
  }
  const [least, most] = [Math.min, Math.max].map((pick) => [0, 1, 2].map((k) =>
    everything.reduce((found, point) => pick(found, point[k]), everything[0][k])));
  const middle = least.map((x, k) => (x + most[k]) / 2);
  const floor = least[2] - 25;
  const reach = 20 + Math.max(...everything.map((p) => Math.hypot(p[0] - middle[0], p[1] - middle[1])));
  const height = 20 + reach * Math.sin(elevation) + (most[2] - floor) / 2 * Math.cos(elevation);
  middle[2] = (most[2] + floor) / 2;
  machine.setAttribute('viewBox', [-reach, -height, 2 * reach, 2 * height].map((x) => x.toFixed(1)).join(' '));

  /** Orthographic projection of a point, and how near a direction points to who looks. */
  function projection() {
    const azimuth = view.value * Math.PI / 180;
    const [c, s, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
    const [right, up, near] = [[-s, c, 0], [-se * c, -se * s, ce], [ce * c, ce * s, se]];
    const text = (point) => {
      const from = point.map((x, k) => x - middle[k]);
      return `${dot(right, from).toFixed(2)},${(-dot(up, from)).toFixed(2)}`;
    };
    return {text, path: (all) => all.map((line) => `M${line.map(text).join('L')}`).join(''), near: (v) => dot(near, v)};
  }

  /** Faces of a block that are seen. */
  function faces(at, seen) {
    const all = [];
    for (let k = 0; k < 3; ++k) {
      for (const side of [-1, 1]) {
        const normal = [0, 0, 0];
        normal[k] = side;
        if (seen.near(at.turned(normal)) <= 0) continue;
        const corner = (a, b) => {
          const v = [0, 0, 0];
          v[k] = side * block[k];
          v[(k + 1) % 3] = a * block[(k + 1) % 3];
          v[(k + 2) % 3] = b * block[(k + 2) % 3];
          return sum(at.place, at.turned(v));
        };
        all.push([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)]);
      }
    }
    return all;
  }

  const drawn = Object.fromEntries([['shadow', 'shadow'], ['axes', 'ground'], ['way', 'orbit'], ['frame', 'ground'],
    ['block', 'journal'], ['links', 'link'], ['pin', 'pin'], ['joints', 'centre']].map(([key, look]) =>
    [key, page.add(machine, 'path', {class: look})]));
  const letters = ['x', 'y', 'z'].map((letter) => page.add(machine, 'text', {'text-anchor': 'middle'}, letter));

  for (const share of [0.25, 0.5, 0.75]) page.add(orbit, 'circle', {class: 'ring', r: share * wall});
  page.add(orbit, 'circle', {class: 'clearance', r: wall});
  page.add(orbit, 'path', {class: 'ring', d: `M${-wall},0H${wall}M0,${-wall}V${wall}`});
  page.add(orbit, 'text', {x: 0, y: -wall - 5, 'text-anchor': 'middle'}, 'ε = 1');
  page.add(orbit, 'text', {x: wall - 2, y: -4, 'text-anchor': 'end'}, 'along the rod');
  const places = film.map((_, i) => `${(wall * e[2 * i]).toFixed(2)},${(-wall * e[2 * i + 1]).toFixed(2)}`);
  page.add(orbit, 'path', {class: 'orbit', d: `M${places.join('L')}`});
  const trail = page.add(orbit, 'path', {class: 'trail'});
  const push = page.add(orbit, 'path', {class: 'arrow'});
  const centre = page.add(orbit, 'circle', {class: 'centre', r: 3.2});
  const numbers = page.numbers('space-numbers', {time: 'time', ratio: 'ε = e/c', film: 'least film',
    force: 'force on the journal'});

  /** What does not move but with the view. */
  function drawGround(seen) {
    drawn.axes.setAttribute('d', seen.path(data.axes.map((line) => line.map(scaled))));
    const ways = bodies[0].arms.map((arm) => film.map((_, i) => placed(bodies[0], i).at(arm)));
    drawn.way.setAttribute('d', seen.path(ways));
    const units = [[40, 0, 0], [0, 40, 0], [0, 0, 40]];
    drawn.frame.setAttribute('d', seen.path(units.map((unit) => [[0, 0, 0], unit])));
    units.forEach((unit, k) => {
      const [x, y] = seen.text(unit.map((value) => 1.2 * value)).split(',');
      letters[k].setAttribute('x', x);
      letters[k].setAttribute('y', +y + 3);
    });
  }

  function draw(frame) {
    const seen = projection();
    const at = bodies.map((body) => placed(body, frame));
    const links = bodies.flatMap((body, i) => lines(body, at[i]));
    drawn.links.setAttribute('d', seen.path(links));
    drawn.shadow.setAttribute('d', seen.path(links.map((line) => line.map(([x, y]) => [x, y, floor]))));
    drawn.block.setAttribute('d', bodies.flatMap((body, i) => body.arms.length ? [] : faces(at[i], seen))
      .map((face) => seen.path([face]) + 'z').join(''));
    drawn.pin.setAttribute('d', seen.path([data.pin.ends.map(at[data.pin.body].at)]));
    const ends = links.map(([, end]) => seen.text(end).split(',').map(Number));
    drawn.joints.setAttribute('d', ends.map(([x, y]) => page.circle(x, y, 3)).join(''));

    const [ex, ey, fx, fy] = [e, force].flatMap((list) => [0, 1].map((k) => page.between(list, 2, k, frame)));
    const [x, y] = [wall * ex, -wall * ey];
    trail.setAttribute('d', `M${[...places.slice(0, Math.floor(frame) + 1), `${x},${y}`].join('L')}`);
    push.setAttribute('d', page.arrow(x, y, longest * fx / mostForce, -longest * fy / mostForce));
    centre.setAttribute('cx', x);
    centre.setAttribute('cy', y);
    const seconds = data.end * frame / Math.max(data.frames - 1, 1);
    const thickness = page.between(film, 1, 0, frame);
    const ratio = 1 - thickness / data.clearance;
    numbers.time.textContent = `${seconds.toFixed(3)} s`;
    numbers.ratio.textContent = ratio.toFixed(4);
    numbers.film.textContent = `${+(1e6 * thickness).toPrecision(4)} µm`;
    numbers.force.textContent = `${+Math.hypot(fx, fy).toPrecision(4)} N`;
    return `${numbers.time.textContent}, ε ${ratio.toFixed(3)}`;
  }

  const player = page.player('space', draw);
  view.addEventListener('input', () => {
    drawGround(projection());
    player.redraw();
  });
  drawGround(projection());
  player.show(data.frames, 0.4);
})();
