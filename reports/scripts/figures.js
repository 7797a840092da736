// Figures that can be pointed at, enlarged and read by keyboard. The drawing is complete without this script; what it
// relies on is described in compact.py. d3 (d3-zoom) is there only if its package was when the page was made.
'use strict';
(() => {
  const SVG = 'http://www.w3.org/2000/svg';
  const REACH = 26; // units of the drawing within which a point is found
  const MOST_SAMPLES = 60; // of a line without marks, in the table of values and by keyboard
  const figures = new WeakMap();

  const make = (tag, attributes = {}, text = '') => {
    const element = tag.startsWith('svg:')
      ? document.createElementNS(SVG, tag.slice(4))
      : document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(text);
    return element;
  };

  // --- numbers and axes ---------------------------------------------------------------------------

  const superscript = power => String(power).replace(/[-0-9]/g, digit => (digit === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]));
  function number(value, digits = 4) {
    if (value === 0 || !isFinite(value)) return value === 0 ? '0' : '—';
    if (Math.abs(value) >= 0.001 && Math.abs(value) < 1e5)
      return String(Number(value.toPrecision(digits))).replace('-', '−');
    const [factor, power] = value.toExponential(digits - 1).split('e');
    return `${String(Number(factor)).replace('-', '−')}·10${superscript(Number(power))}`;
  }

  // Values along an axis of linear (0), logarithmic (1) or symmetric logarithmic ([threshold, decades]) scale.
  function scale(kind, low, high) {
    const [forward, back] =
      kind === 0
        ? [v => v, v => v]
        : kind === 1
          ? [v => Math.log10(v), v => 10 ** v]
          : [
              v =>
                Math.abs(v) <= kind[0]
                  ? (v * kind[1]) / 0.9
                  : Math.sign(v) * kind[0] * (kind[1] / 0.9 + Math.log10(Math.abs(v) / kind[0])),
              v =>
                Math.abs(v) <= (kind[0] * kind[1]) / 0.9
                  ? (v / kind[1]) * 0.9
                  : Math.sign(v) * kind[0] * 10 ** (Math.abs(v) / kind[0] - kind[1] / 0.9),
            ];
    const [a, b] = [forward(low), forward(high)];
    return { log: kind === 1, place: v => (forward(v) - a) / (b - a), value: share => back(a + share * (b - a)) };
  }

  function ticks(low, high, log) {
    if (!(high > low)) return [];
    if (log && high / low > 8) {
      const found = [],
        decades = Math.log10(high / low),
        digits = decades > 2.5 ? [1] : [1, 2, 5];
      const every = Math.max(1, Math.round(decades / 6));
      for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power += 1)
        if (power % every === 0) found.push(...digits.map(digit => digit * 10 ** power));
      return found.filter(value => value >= low && value <= high);
    }
    const rough = (high - low) / 5,
      power = 10 ** Math.floor(Math.log10(rough));
    const step = power * [1, 2, 5, 10].find(factor => factor * power >= rough);
    const found = [];
    for (let count = Math.ceil(low / step); count * step <= high && found.length < 20; count += 1)
      found.push(count * step);
    return found;
  }

  // --- paths --------------------------------------------------------------------------------------

  // [[letter, [absolute coordinates]]]; of marks each M with the text that draws the mark.
  function parse(path) {
    const data = path.getAttribute('d');
    if (path.classList.contains('m'))
      return data
        .split('M')
        .slice(1)
        .map(part => {
          const [, x, y, shape] = part.match(/^(-?[\d.]+) ?(-?[\d.]+)(.*)$/);
          return ['M', [Number(x), Number(y)], shape];
        });
    const found = [];
    let x = 0,
      y = 0,
      start = [0, 0];
    for (const [, letter, words] of data.matchAll(/([MlhvcqzL])([^MlhvcqzL]*)/g)) {
      const values = (words.match(/-?(?:\d+\.?\d*|\.\d+)/g) || []).map(Number);
      if (letter === 'z') {
        found.push(['z', []]);
        [x, y] = start;
      } else if (letter === 'M') {
        [x, y] = start = values;
        found.push(['M', [x, y]]);
      } else if (letter === 'h')
        for (const step of values) {
          x += step;
          found.push(['L', [x, y]]);
        }
      else if (letter === 'v')
        for (const step of values) {
          y += step;
          found.push(['L', [x, y]]);
        }
      else {
        const size = { l: 2, q: 4, c: 6 }[letter];
        for (let at = 0; at + size <= values.length; at += size) {
          const places = values.slice(at, at + size).map((value, index) => value + (index % 2 ? y : x));
          found.push([letter.toUpperCase(), places]);
          [x, y] = places.slice(-2);
        }
      }
    }
    return found;
  }

  const written = (commands, move) =>
    commands
      .map(
        ([letter, values, shape = '']) =>
          letter +
          values.map((value, index) => (index % 2 ? move.y(value) : move.x(value)).toFixed(2)).join(' ') +
          shape,
      )
      .join('');

  // --- one figure ---------------------------------------------------------------------------------

  class Figure {
    constructor(drawing) {
      this.drawing = drawing;
      this.figure = drawing.closest('figure');
      const plot = JSON.parse(drawing.dataset.plot);
      this.labels = plot.s || [];
      const groups = [...drawing.querySelectorAll('g.d')];
      this.axes = plot.a.map(([x, y, width, height, ...rest], index) => ({
        x,
        y,
        width,
        height,
        group: groups[index],
        frame: groups[index] && groups[index].parentNode.querySelectorAll('g.x')[index],
        across: scale(...rest.slice(0, 3)),
        up: scale(...rest.slice(3, 6)),
        words: rest.slice(6),
        paths: groups[index]
          ? [...groups[index].querySelectorAll('path')].map(path => ({
              path,
              commands: parse(path),
              data: path.getAttribute('d'),
            }))
          : [],
      }));
      this.zoomed = { k: 1, x: 0, y: 0 };
      this.active = this.axes[0];
      this.lines = this.axes.flatMap(axes => this.linesOf(axes));
      this.at = null; // [line, point] that is pointed at
      if (typeof d3 === 'object' && d3.zoom) this.allowZoom();
      this.addTools();
      drawing.addEventListener('pointermove', event => this.point(event));
      drawing.addEventListener('pointerleave', () => this.leave());
      drawing.addEventListener('keydown', event => this.key(event));
      drawing.addEventListener('blur', () => this.leave());
    }

    // Points of each labelled line; a line whose marks are drawn is read at its marks.
    linesOf(axes) {
      const found = [];
      const labelled = axes.paths.filter(({ path }) => path.dataset.s !== undefined && !path.classList.contains('b'));
      for (const { path, commands } of labelled) {
        const marks = path.classList.contains('m'),
          series = Number(path.dataset.s);
        const marked = labelled.some(
          other => other.path.dataset.s === path.dataset.s && other.path.classList.contains('m'),
        );
        if (!marks && marked) continue;
        const notes = (path.dataset.n || '').split('|');
        const points = commands
          .filter(([letter]) => letter !== 'z')
          .map(([letter, values], index) => ({
            x: values.at(-2),
            y: values.at(-1),
            joined: !marks && letter !== 'M',
            note: marks ? notes[notes.length > 1 ? index : 0] : '',
          }));
        if (points.length) found.push({ axes, series, path, marks, points });
      }
      return found;
    }

    get shown() {
      return this.lines.filter(line => getComputedStyle(line.path).display !== 'none');
    }

    move(axes) {
      const { k, x, y } = this.zoomed,
        same = axes === this.active;
      const shared = same || (axes.x === this.active.x && axes.width === this.active.width);
      return {
        x: shared ? v => k * v + x : v => v,
        y: same ? v => k * v + y : v => v,
        backX: shared ? v => (v - x) / k : v => v,
        backY: same ? v => (v - y) / k : v => v,
      };
    }

    values(line, point) {
      const { axes } = line;
      return [
        axes.across.value((point.x - axes.x) / axes.width),
        axes.up.value(1 - (point.y - axes.y) / axes.height),
      ];
    }

    words(line, point) {
      const digits = line.marks && line.points.length <= 60 ? 4 : 3;
      const [x, y] = this.values(line, point).map(value => number(value, digits));
      return {
        label: this.labels[line.series],
        note: point.note,
        pairs: [
          [line.axes.words[0], x],
          [line.axes.words[1], y],
        ],
      };
    }

    nearest(x, y) {
      let best = null,
        least = REACH;
      for (const line of this.shown) {
        const { axes } = line,
          move = this.move(axes);
        if (x < axes.x - 4 || x > axes.x + axes.width + 4 || y < axes.y - 4 || y > axes.y + axes.height + 4) continue;
        line.points.forEach((point, index) => {
          let [px, py] = [move.x(point.x), move.y(point.y)];
          const before = line.points[index - 1];
          if (point.joined && before) {
            // the foot of the pointer on the piece of line
            const [ax, ay] = [move.x(before.x), move.y(before.y)],
              [dx, dy] = [px - ax, py - ay];
            const share = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
            [px, py] = [ax + share * dx, ay + share * dy];
          }
          const inside =
            px >= axes.x - 1 && px <= axes.x + axes.width + 1 && py >= axes.y - 1 && py <= axes.y + axes.height + 1;
          const away = Math.hypot(px - x, py - y) * (line.marks ? 0.7 : 1);
          if (inside && away < least) {
            least = away;
            best = [line, { ...point, x: move.backX(px), y: move.backY(py) }];
          }
        });
      }
      return best;
    }

    point(event) {
      const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.drawing.getScreenCTM().inverse());
      this.show(this.nearest(place.x, place.y));
    }

    show(found, spoken = false) {
      this.at = found;
      if (!found) return this.leave();
      const [line, point] = found,
        move = this.move(line.axes),
        [x, y] = [move.x(point.x), move.y(point.y)];
      this.ring ??= this.drawing.appendChild(make('svg:circle', { r: 5.5, class: 'hit' }));
      this.ring.setAttribute('cx', x);
      this.ring.setAttribute('cy', y);
      const place = new DOMPoint(x, y).matrixTransform(this.drawing.getScreenCTM());
      readout.show(this.words(line, point), place, spoken);
    }

    leave() {
      this.ring?.remove();
      this.ring = undefined;
      this.at = null;
      readout.hide();
    }

    // Arrows go from point to point and from line to line; +, - and Escape enlarge and restore.
    key(event) {
      const lines = this.shown,
        [line, point] = this.at || [];
      const keys = {
        '+': () => this.by(1.5),
        '=': () => this.by(1.5),
        '-': () => this.by(1 / 1.5),
        0: () => this.reset(),
        Escape: () => this.reset(),
      };
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (keys[event.key]) keys[event.key]();
      else if (event.key.startsWith('Arrow') && lines.length) {
        const at = Math.max(
          0,
          lines.findIndex(other => other.path === line?.path),
        );
        const chosen =
          line && event.key === 'ArrowDown'
            ? lines[(at + 1) % lines.length]
            : line && event.key === 'ArrowUp'
              ? lines[(at + lines.length - 1) % lines.length]
              : lines[at];
        const points = samples(chosen);
        let index = line
          ? points.reduce(
              (best, other, here) => (Math.abs(other.x - point.x) < Math.abs(points[best].x - point.x) ? here : best),
              0,
            )
          : -1;
        const sideways = { ArrowRight: 1, ArrowLeft: -1 }[event.key] || (line ? 0 : 1);
        index = (index + sideways + points.length) % points.length;
        this.show([chosen, points[index]], true);
      } else return;
      event.preventDefault();
    }

    // --- legend, tools, values --------------------------------------------------------------------

    addTools() {
      const tools = make('div', { class: 'tools' });
      const add = (text, title, act) => {
        const button = make('button', { type: 'button', title, 'aria-label': title }, text);
        button.addEventListener('click', () => act(button));
        tools.append(button);
      };
      if (this.zoom) {
        add('+', 'Enlarge', () => this.by(1.5));
        add('−', 'Reduce', () => this.by(1 / 1.5));
        add('⟲', 'Whole figure (Escape)', () => this.reset());
      }
      if (this.lines.length) add('Values', 'Values as a table', button => this.toggleValues(button));
      if (tools.children.length) this.drawing.before(tools);
    }

    toggleValues(button) {
      if (this.table) {
        this.table.remove();
        this.table = undefined;
      } else {
        this.table = make('div', {
          class: 'scroll tall values',
          tabindex: 0,
          role: 'region',
          'aria-label': `Values of ${this.drawing.getAttribute('aria-label')}`,
        });
        const table = this.table.appendChild(make('table')),
          body = make('tbody');
        const [x, y] = this.axes[0].words;
        table.append(make('thead'), body);
        const head = table.tHead.insertRow();
        for (const name of ['Line', '', x, this.axes.length > 1 ? 'value' : y])
          head.append(make('th', { scope: 'col' }, name));
        for (const line of this.lines)
          for (const point of samples(line)) {
            const { label, note, pairs } = this.words(line, point),
              row = body.insertRow();
            row.append(
              make('th', { scope: 'row' }, label),
              make('td', {}, this.axes.length > 1 ? pairs[1][0] : note || ''),
            );
            for (const [, value] of pairs) row.append(make('td', { class: 'num' }, value));
          }
        this.drawing.after(this.table);
      }
      button.setAttribute('aria-expanded', String(Boolean(this.table)));
    }

    // --- zoom -------------------------------------------------------------------------------------

    allowZoom() {
      // A wheel over a figure scrolls the page until the figure has the focus; one finger scrolls until it is enlarged.
      const drawing = this.drawing;
      const wanted = event =>
        event.type === 'wheel'
          ? event.ctrlKey || document.activeElement === drawing
          : event.type.startsWith('touch')
            ? event.touches.length > 1 || this.zoomed.k > 1
            : event.type === 'dblclick' || (this.zoomed.k > 1 && !event.button);
      this.zoom = d3
        .zoom()
        .scaleExtent([1, 200])
        .filter(event => wanted(d3.event || event))
        .extent(() => this.box())
        .on('zoom', event => this.apply((d3.event || event).transform))
        .on('start', event => this.choose((d3.event || event).sourceEvent));
      this.zoom.translateExtent(this.box());
      d3.select(drawing).call(this.zoom);
      drawing.style.touchAction = 'pan-x pan-y';
    }

    box() {
      const { x, y, width, height } = this.active;
      return [
        [x, y],
        [x + width, y + height],
      ];
    }

    choose(event) {
      if (this.zoomed.k > 1 || !event || event.clientX === undefined) return;
      const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.drawing.getScreenCTM().inverse());
      const under = this.axes.find(
        axes =>
          place.x >= axes.x && place.x <= axes.x + axes.width && place.y >= axes.y && place.y <= axes.y + axes.height,
      );
      this.active = under || this.active;
      this.zoom.translateExtent(this.box());
    }

    by(factor) {
      if (this.zoom) d3.select(this.drawing).call(this.zoom.scaleBy, factor);
    }
    reset() {
      if (this.zoom) d3.select(this.drawing).call(this.zoom.transform, d3.zoomIdentity);
    }

    apply({ k, x, y }) {
      this.zoomed = k > 1.0001 ? { k, x, y } : { k: 1, x: 0, y: 0 };
      const enlarged = this.zoomed.k > 1;
      this.drawing.classList.toggle('zoomed', enlarged);
      this.drawing.style.touchAction = enlarged ? 'none' : 'pan-x pan-y';
      for (const axes of this.axes) {
        const move = this.move(axes);
        for (const { path, commands, data } of axes.paths)
          path.setAttribute('d', enlarged ? written(commands, move) : data);
        for (const image of axes.group?.querySelectorAll('image') || []) {
          image.dataset.transform ??= image.getAttribute('transform') || '';
          const [sx, sy] = [move.x(1) - move.x(0), move.y(1) - move.y(0)];
          image.setAttribute(
            'transform',
            `matrix(${sx} 0 0 ${sy} ${move.x(0)} ${move.y(0)}) ${image.dataset.transform}`,
          );
        }
        this.clip(axes);
        this.drawTicks(axes, move, enlarged);
      }
      if (this.at) this.show(this.at);
    }

    clip(axes) {
      if (!axes.group || axes.group.hasAttribute('clip-path')) return;
      const id = `clip-${Math.random().toString(36).slice(2)}`,
        { x, y, width, height } = axes;
      const clip = make('svg:clipPath', { id });
      clip.append(make('svg:rect', { x, y, width, height }));
      axes.group.before(clip);
      axes.group.setAttribute('clip-path', `url(#${id})`);
    }

    // The drawn frame keeps its labels; its grid and ticks give way to those of the part that is shown.
    drawTicks(axes, move, enlarged) {
      axes.ticks?.remove();
      axes.ticks = undefined;
      if (!axes.frame) return;
      const inside = text =>
        Number(text.getAttribute('y')) < axes.y + axes.height && Number(text.getAttribute('x')) > axes.x;
      for (const text of this.drawing.querySelectorAll(':scope > text'))
        text.style.display = enlarged && inside(text) ? 'none' : '';
      const labels = [...axes.frame.querySelectorAll('text')].filter(text => !axes.words.includes(text.textContent));
      const below = labels.some(text => Number(text.getAttribute('y')) > axes.y + axes.height);
      const beside = labels.some(text => text.hasAttribute('x') && Number(text.getAttribute('x')) < axes.x);
      for (const element of [...axes.frame.querySelectorAll('path'), ...labels])
        element.style.display = enlarged ? 'none' : '';
      if (!enlarged) return;
      const { x, y, width, height, across, up } = axes;
      const low = across.value((move.backX(x) - x) / width),
        high = across.value((move.backX(x + width) - x) / width);
      const bottom = up.value(1 - (move.backY(y + height) - y) / height),
        top = up.value(1 - (move.backY(y) - y) / height);
      const found = make('svg:g', { class: 'zoom-ticks' });
      let grid = '';
      for (const value of ticks(low, high, across.log)) {
        const place = move.x(x + width * across.place(value));
        grid += `M${place} ${y}v${height}`;
        if (below)
          found.append(make('svg:text', { x: place, y: y + height + 13, 'text-anchor': 'middle' }, number(value)));
      }
      for (const value of ticks(bottom, top, up.log)) {
        const place = move.y(y + height * (1 - up.place(value)));
        grid += `M${x} ${place}h${width}`;
        if (beside) found.append(make('svg:text', { x: x - 4, y: place + 3, 'text-anchor': 'end' }, number(value)));
      }
      found.prepend(
        make('svg:path', { d: grid, class: 'grid' }),
        make('svg:path', { d: `M${x} ${y}v${height}h${width}`, class: 'frame' }),
      );
      axes.frame.prepend(found);
      axes.ticks = found;
    }
  }

  // Points of a line, of a long one without marks some.
  function samples(line) {
    const every = line.marks ? 1 : Math.max(1, Math.ceil(line.points.length / MOST_SAMPLES));
    return line.points.filter((_, index) => index % every === 0);
  }

  // --- what is said of a point --------------------------------------------------------------------

  const readout = {
    box: make('div', { class: 'readout', 'aria-hidden': 'true' }),
    live: make('div', { class: 'unseen', role: 'status' }),
    show({ label, note, pairs }, place, spoken) {
      const { box } = this;
      box.replaceChildren(
        make('strong', {}, label || ''),
        ...(note ? [make('span', {}, note)] : []),
        ...pairs.map(([name, value]) => {
          const row = make('span', {}, `${name} = `);
          row.append(make('b', {}, value));
          return row;
        }),
      );
      box.classList.add('on');
      const { width, height } = box.getBoundingClientRect(),
        edge = document.documentElement.clientWidth;
      const left = Math.max(4, Math.min(place.x + 14, edge - width - 6));
      const above = place.y - height - 12;
      box.style.left = `${left + scrollX}px`;
      box.style.top = `${(above > 2 ? above : place.y + 16) + scrollY}px`;
      if (spoken) this.live.textContent = box.innerText.replace(/\n+/g, ', ');
    },
    hide() {
      this.box.classList.remove('on');
    },
  };

  function activate(drawing) {
    if (!figures.has(drawing)) figures.set(drawing, new Figure(drawing));
    return figures.get(drawing);
  }

  // --- legends ------------------------------------------------------------------------------------

  // A line switched off in one legend is off in all figures of its case or section that have it.
  function toggle(button) {
    const label = button.textContent.trim(),
      off = button.getAttribute('aria-pressed') === 'true';
    const part = button.closest('article, section[id]') || document;
    for (const other of part.querySelectorAll('.key button'))
      if (other.textContent.trim() === label) other.setAttribute('aria-pressed', String(!off));
    for (const drawing of part.querySelectorAll('svg.pl[data-plot]')) {
      const series = (JSON.parse(drawing.dataset.plot).s || []).indexOf(label);
      if (series >= 0)
        for (const path of drawing.querySelectorAll(`[data-s="${series}"]`)) path.classList.toggle('off', off);
    }
  }

  function prepareLegend(figure, drawing) {
    const labels = JSON.parse(drawing.dataset.plot).s || [];
    if (labels.length < 2) return;
    for (const entry of figure.querySelectorAll('.key li')) {
      if (!labels.includes(entry.textContent.trim())) continue;
      const button = make('button', { type: 'button', 'aria-pressed': 'true', title: 'Show or hide this line' });
      button.append(...entry.childNodes);
      entry.append(button);
    }
  }

  document.addEventListener('DOMContentLoaded', () => {
    document.body.append(readout.box, readout.live);
    for (const drawing of document.querySelectorAll('svg.pl[data-plot]')) {
      drawing.tabIndex = 0;
      const figure = drawing.closest('figure');
      if (figure) prepareLegend(figure, drawing);
    }
  });
  for (const kind of ['pointerover', 'focusin'])
    document.addEventListener(kind, event => {
      const figure = event.target.closest?.('figure'),
        drawing = figure?.querySelector('svg.pl[data-plot]');
      if (drawing) activate(drawing);
    });
  document.addEventListener('click', event => {
    const button = event.target.closest?.('.key button');
    if (button) toggle(button);
  });
})();
