'use strict';

// What the animations share: numbers that the page carries packed (packed_numbers.hpp), a clock with its controls.
Object.assign(page, (() => {
  /** Numbers of a kind, from base64 of little-endian bytes. */
  function unpack(text, size, read) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    return Array.from({length: bytes.length / size}, (_, i) => read(view, i * size));
  }
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  const secondsOfRun = 16;  // a run lasts so long on the screen, at speed 1

  return {
    int8s: (text) => unpack(text, 1, (view, at) => view.getInt8(at) / 127),
    int16s: (text) => unpack(text, 2, (view, at) => view.getInt16(at, true) / 32767),
    floats: (text) => unpack(text, 4, (view, at) => view.getFloat32(at, true)),

    /** Number at a place of a list of so many a frame, at a frame that may lie between two. */
    between(list, width, index, frame) {
      const last = list.length / width - 1;
      const low = Math.min(Math.floor(frame), last);
      const high = Math.min(low + 1, last);
      const share = frame - low;
      return list[width * low + index] * (1 - share) + list[width * high + index] * share;
    },

    /** Paths of a circle and of an arrow from a point. */
    circle: (x, y, r) => `M${x - r},${y}a${r},${r} 0 1,0 ${2 * r},0a${r},${r} 0 1,0 ${-2 * r},0z`,
    arrow(x, y, dx, dy) {
      const length = Math.hypot(dx, dy);
      if (length < 1) return '';
      const [ux, uy] = [dx / length, dy / length];
      const [hx, hy] = [x + dx, y + dy];
      const head = Math.min(7, length / 2);
      return `M${x},${y}L${hx},${hy}M${hx},${hy}L${hx - head * (ux - uy / 2)},${hy - head * (uy + ux / 2)}` +
        `L${hx - head * (ux + uy / 2)},${hy - head * (uy - ux / 2)}z`;
    },

    /** Fills a list of numbers with its rows, by key what each is called. @returns by key where its number goes */
    numbers(id, rows) {
      const list = page.element(id);
      list.replaceChildren();
      return Object.fromEntries(Object.entries(rows).map(([key, words]) => {
        const row = page.add(list, 'div');
        page.add(row, 'dt', {}, words);
        return [key, page.add(row, 'dd')];
      }));
    },

    /**
     * Play, slider and speed of the animation of that name (player.html).
     * @param draw  draws a frame, which may lie between two, and returns it in words
     */
    player(name, draw) {
      const [play, slider, speed] = ['play', 'time', 'speed'].map((part) => page.element(`${name}-${part}`));
      let last = 0;
      let frame = 0;
      let playing = false;
      let before = 0;

      function redraw() {
        const words = draw(frame);
        slider.value = Math.round(frame);
        slider.setAttribute('aria-valuetext', words);
      }

      function setPlaying(on) {
        playing = on;
        play.textContent = on ? 'Pause' : 'Play';
        if (!on) return;
        if (frame >= last) frame = 0;
        before = performance.now();
        requestAnimationFrame(advance);
      }

      function advance(now) {
        if (!playing) return;
        // For those who asked for less motion: four pictures a second, and only when they press Play.
        if (!still.matches || now - before >= 250) {
          frame += (now - before) / 1e3 / secondsOfRun * speed.value * last;
          before = now;
          if (frame >= last) {
            frame = last;
            setPlaying(false);
          }
          redraw();
        }
        if (playing) requestAnimationFrame(advance);
      }

      /** Stops, and shows a run of so many frames, at a share of it. */
      function show(frames, share) {
        setPlaying(false);
        last = frames - 1;
        slider.max = last;
        frame = Math.round(last * share);
        redraw();
      }

      play.addEventListener('click', () => setPlaying(!playing));
      slider.addEventListener('input', () => {
        setPlaying(false);
        frame = +slider.value;
        redraw();
      });
      return {show, redraw};
    },
  };
})());
