// Filters, links to everything, and the dark page. The page is whole without this script.
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
          : part.querySelector('h1, h2, h3, h4');
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

  // --- the catalog by verdict ------------------------------------------------------------------------

  function addCatalogFilter() {
    const boxes = all('#overview [data-choose]'),
      cards = all('.catalog [data-case]'),
      said = document.getElementById('cases-shown');
    const update = () => {
      const chosen = boxes.filter(box => box.checked).map(box => box.value);
      for (const card of cards)
        card.hidden = chosen.length > 0 && !card.dataset.verdicts.split(' ').some(name => chosen.includes(name));
      said.textContent = chosen.length
        ? `${cards.filter(card => !card.hidden).length} of ${cards.length} cases`
        : '';
    };
    for (const box of boxes) box.addEventListener('change', update);
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

  // --- dark page -------------------------------------------------------------------------------------

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
    addCatalogFilter();
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
