// Search, filters, links to everything, the dark page and printing. The page is whole without this script.
'use strict';
(() => {
  const all = (selector, part = document) => [...part.querySelectorAll(selector)];
  const make = (tag, attributes = {}, ...content) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...content);
    return element;
  };
  const plain = text =>
    text
      .toLowerCase()
      .normalize('NFD')
      .replace(/[\u0300-\u036f]/g, '')
      .replace(/\s+/g, ' ');
  const matches = (text, words) => words.every(word => text.includes(word));
  const split = text => plain(text).split(' ').filter(Boolean);

  // --- links: what a link points at is shown, wherever it is folded away -----------------------------

  function reveal(target) {
    for (let part = target?.closest('details'); part; part = part.parentElement?.closest('details')) part.open = true;
    for (let part = target; part; part = part.parentElement) part.hidden = false;
  }

  function followHash() {
    const id = decodeURIComponent(location.hash.slice(1)),
      target = id && document.getElementById(id);
    if (!target) return;
    reveal(target);
    // Only now does it have its place.
    requestAnimationFrame(() => target.scrollIntoView());
  }

  function addLinks() {
    for (const part of all('main :is(section, article, details)[id], main tr[id], figure > svg.pl[id]')) {
      const place = part.matches('tr')
        ? part.querySelector('th')
        : part.matches('svg')
          ? part.parentElement.querySelector('.plot-title')
          : part.querySelector('h2, h3, h4');
      if (
        !place ||
        place.querySelector('.anchor') ||
        (part.matches('section, article') && place.closest('[id]:is(section, article)') !== part)
      )
        continue;
      const link = make(
        'a',
        {
          class: 'anchor',
          href: `#${part.id}`,
          title: 'Link to this; copied when clicked',
          'aria-label': `Link to ${place.textContent.trim().slice(0, 60)}`,
        },
        '#',
      );
      link.addEventListener('click', () => navigator.clipboard?.writeText(link.href).catch(() => {}));
      place.append(' ', link);
    }
  }

  // --- search over cases -----------------------------------------------------------------------------

  const MOST_GATES = 12;

  function searchIndex() {
    return all('article.case').map(article => ({
      id: article.id,
      text: plain(
        [
          ...all(':scope > header, .claim-text', article),
          document.querySelector(`#overview tr[data-case="${article.id}"]`),
        ]
          .map(part => part?.textContent || '')
          .join(' '),
      ),
      gates: all('table.gates tbody tr[id], .identities [id]', article).map(row => ({
        row,
        text: plain(
          row.id +
            ' ' +
            (row.cells ? row.querySelector('th').textContent + row.cells[2].textContent : row.textContent),
        ),
      })),
    }));
  }

  function addSearch() {
    const box = document.getElementById('search'),
      list = document.getElementById('found'),
      count = document.getElementById('found-count');
    const chosen = { verdict: new Set(), kind: new Set() };
    let index;
    const rows = all('#overview tr[data-case]'),
      links = all('.case-links li');
    function update() {
      index ??= searchIndex();
      const words = split(box.value),
        found = new Set(),
        gates = [];
      for (const entry of index) {
        const row = rows.find(other => other.dataset.case === entry.id);
        const allowed =
          (!chosen.verdict.size || (row?.dataset.verdicts || '').split(' ').some(name => chosen.verdict.has(name))) &&
          (!chosen.kind.size || chosen.kind.has(row?.dataset.kind));
        if (!allowed) continue;
        const own = matches(entry.text, words);
        const hits = words.length
          ? entry.gates.filter(gate =>
              own ? matches(gate.text, words) : matches(`${entry.text} ${gate.text}`, words),
            )
          : [];
        if (own || hits.length) found.add(entry.id);
        gates.push(...hits);
      }
      for (const row of rows) row.hidden = !found.has(row.dataset.case);
      for (const item of links) item.hidden = !found.has(item.firstElementChild.hash.slice(1));
      list.replaceChildren(
        ...gates
          .slice(0, MOST_GATES)
          .map(({ row }) => make('li', {}, make('a', { href: `#${row.id}` }, row.id.replace(/^gate-/, '')))),
      );
      const narrowed = words.length || chosen.verdict.size || chosen.kind.size;
      count.textContent = !narrowed
        ? ''
        : `${found.size} of ${index.length} cases` +
          (gates.length
            ? `, ${gates.length} ${gates.length === 1 ? 'gate' : 'gates'}${gates.length > MOST_GATES ? `, the first ${MOST_GATES} below` : ''}`
            : '');
      for (const note of all('[data-found-count]')) note.textContent = count.textContent;
    }
    if (!box) return;
    box.addEventListener('input', update);
    box.addEventListener('keydown', event => {
      if (event.key === 'Escape') {
        box.value = '';
        update();
      }
      if (event.key !== 'Enter') return;
      const first = document.querySelector('#found a, .case-links li:not([hidden]) a');
      if (box.value && first) location.hash = first.hash;
    });
    for (const input of all('#overview [data-choose]'))
      input.addEventListener('change', () => {
        chosen[input.dataset.choose][input.checked ? 'add' : 'delete'](input.value);
        update();
      });
    document.addEventListener('keydown', event => {
      if (event.key === '/' && !event.target.closest('input, textarea, select')) {
        event.preventDefault();
        box.focus();
      }
    });
  }

  // --- tables with a filter --------------------------------------------------------------------------

  // Rows of one group (tbody with cells over several rows) stay together.
  function addTableFilter(table) {
    const reason = part => part.parentElement.querySelector(':scope > .why'); // of the gates of a group
    const parts = [...table.tBodies].flatMap(body =>
      body.querySelector('[rowspan]') ? [body] : [...body.rows].filter(row => !row.matches('.why')),
    );
    if (parts.length < 8) return;
    const texts = new Map(parts.map(part => [part, plain(`${part.textContent} ${reason(part)?.textContent || ''}`)]));
    const verdicts = [
      ...new Set(parts.flatMap(part => all('.chip', part).map(chip => chip.textContent.trim().split(' ')[0]))),
    ];
    const box = make('input', {
      type: 'search',
      placeholder: 'Filter rows',
      'aria-label': `Filter rows of: ${table.caption?.textContent.trim() || 'this table'}`,
    });
    const said = make('span', { class: 'sub', role: 'status' });
    const bar = make('div', { class: 'filter' }, box);
    const boxes =
      verdicts.length > 1
        ? verdicts.map(name => {
            const input = make('input', { type: 'checkbox', value: name });
            bar.append(make('label', {}, input, ` ${name}`));
            return input;
          })
        : [];
    bar.append(said);
    const update = () => {
      const words = split(box.value),
        chosen = boxes.filter(input => input.checked).map(input => input.value);
      let left = 0;
      for (const part of parts) {
        const shown =
          matches(texts.get(part), words) &&
          (!chosen.length || all('.chip', part).some(chip => chosen.includes(chip.textContent.trim().split(' ')[0])));
        part.hidden = !shown;
        left += shown;
      }
      for (const row of all('tbody > .why', table))
        row.hidden = !row.parentElement.querySelector(':scope > tr:not(.why, [hidden])');
      said.textContent = left === parts.length ? '' : `${left} of ${parts.length} rows`;
    };
    bar.addEventListener('input', update);
    (table.closest('.scroll') || table).before(bar);
  }

  // Tables that become cards on a narrow page keep their meaning in browsers that go by how a table is laid out.
  function addTableRoles() {
    const roles = { TABLE: 'table', THEAD: 'rowgroup', TBODY: 'rowgroup', TR: 'row', TD: 'cell' };
    for (const table of all('table.cards'))
      for (const part of [table, ...all('thead, tbody, tr, th, td', table)])
        if (!part.hasAttribute('role'))
          part.setAttribute('role', roles[part.tagName] || { col: 'columnheader' }[part.scope] || 'rowheader');
  }

  // --- dark page, printing ---------------------------------------------------------------------------

  function addThemeSwitch() {
    const button = document.getElementById('theme');
    if (!button) return;
    const label = () => {
      button.textContent = theme.dark ? 'Light' : 'Dark';
      button.setAttribute('aria-label', `${button.textContent} page`);
    };
    button.hidden = false;
    button.addEventListener('click', () => {
      const name = theme.dark ? 'light' : 'dark';
      theme.choose(name);
      theme.store(name);
      label();
    });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', label);
    label();
  }

  let closed = [];
  addEventListener('beforeprint', () => {
    closed = all('details:not([open])');
    for (const part of closed) part.open = true;
  });
  addEventListener('afterprint', () => {
    for (const part of closed) part.open = false;
    closed = [];
  });

  // Of the comparisons with earlier results the chosen one is shown.
  function addComparison() {
    document.querySelector('[data-compare]')?.addEventListener('change', event => {
      for (const part of all('[data-comparison]')) part.hidden = part.dataset.comparison !== event.target.value;
    });
  }

  document.addEventListener('DOMContentLoaded', () => {
    for (const part of all('[data-needs-script]')) part.hidden = false;
    addThemeSwitch();
    addComparison();
    addTableRoles();
    addLinks();
    addSearch();
    for (const table of all('table[data-filter]')) addTableFilter(table);
    addEventListener('hashchange', followHash);
    document.addEventListener('click', event => {
      // a link to where the page already is
      const link = event.target.closest?.('a[href^="#"]');
      if (link && link.hash === location.hash) followHash();
    });
    followHash();
  });
})();
