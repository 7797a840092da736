// Search over the words of all pages. The words are a script beside the pages, loaded when somebody searches, or when an
// address names a part that stands on another page than it did. A report in one file is read for its words itself.
'use strict';
const plumblineSearch = (() => {
  const MOST_PAGES = 12;
  const MOST_PLACES = 4; // of one page
  const isFolder = 'root' in document.documentElement.dataset;
  const root = document.documentElement.dataset.root ?? '';
  const plain = text => text.toLowerCase().normalize('NFD').replace(/[\u0300-\u036f]/g, '');
  let index, asked;

  const make = (tag, attributes, ...content) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...content);
    return element;
  };

  function load() {
    asked ??= new Promise((done, failed) => {
      if (!isFolder) index ??= wordsOfThisFile();
      if (index) return done();
      const script = make('script', { src: `${root}shared/words.js` });
      script.addEventListener('load', done);
      script.addEventListener('error', failed);
      document.head.append(script);
    });
    return asked;
  }

  // As search_index.py makes it of a folder: whatever a link can lead to is a place, with the words up to the next one. Each
  // section and each case stands for a page.
  function wordsOfThisFile() {
    const pages = [], places = [], at = new Map();
    const titled = part => part.querySelector('h1, h2, h3, h4, th, summary, caption, .plot-title')?.textContent.trim().slice(0, 90) ?? '';
    const add = text => {
      for (const whole of plain(text).match(/[\p{L}\p{N}](?:[\p{L}\p{N}_.+'’-]*[\p{L}\p{N}])?/gu) ?? [])
        for (const word of [whole, ...whole.match(/[\p{L}\p{N}]+/gu)]) {
          if (word.length < 2 || /^[\d.+\-e×]*$/.test(word)) continue;
          if (!at.has(word)) at.set(word, new Set());
          at.get(word).add(places.length - 1);
        }
    };
    const visit = (node, page) => {
      if (node.nodeType === Node.TEXT_NODE) return add(node.data);
      if (node.nodeType !== Node.ELEMENT_NODE || node.matches('script, style')) return;
      if (node.id && node.parentElement.tagName !== 'MAIN') places.push([page, node.id, node.matches('svg') ? titled(node.parentElement) : titled(node)]);
      if (node.matches('svg')) return add(node.getAttribute('aria-label') ?? '');
      for (const child of node.childNodes) visit(child, page);
    };
    for (const part of document.querySelectorAll('main > [id]')) {
      places.push([pages.push(['', titled(part)]) - 1, part.id, titled(part)]);
      visit(part, pages.length - 1);
    }
    const steps = found => [...found].map((place, number, all) => (place - (number ? all[number - 1] : 0)).toString(36)).join(' ');
    return { pages, places, words: Object.fromEntries([...at].map(([word, found]) => [word, steps(found)])) };
  }

  function places(word) {
    const found = new Set();
    for (const [known, steps] of Object.entries(index.words)) {
      if (!known.includes(word)) continue;
      let place = 0;
      for (const step of steps.split(' ')) found.add((place += parseInt(step, 36)));
    }
    return found;
  }

  // Pages that have all words, those that have them in one place first; of each the places that say most of them in their title.
  function search(words) {
    const perWord = words.map(places);
    const pages = new Map();
    perWord.forEach((found, number) => {
      for (const place of found) {
        const page = index.places[place][0];
        if (!pages.has(page)) pages.set(page, { page, words: new Set(), places: new Map() });
        const entry = pages.get(page);
        entry.words.add(number);
        entry.places.set(place, (entry.places.get(place) || 0) + 1);
      }
    });
    const titled = title => words.filter(word => plain(title).includes(word)).length;
    return [...pages.values()]
      .filter(entry => entry.words.size === words.length)
      .map(entry => {
        const most = Math.max(...entry.places.values());
        const best = [...entry.places]
          .filter(([, count]) => count === most)
          .map(([place]) => ({ name: index.places[place][1], title: index.places[place][2] }));
        for (const place of best) place.score = titled(place.title);
        best.sort((a, b) => b.score - a.score);
        const [path, title] = index.pages[entry.page];
        return { path, title, best, score: 100 * titled(title) + 10 * most + best[0].score };
      })
      .sort((a, b) => b.score - a.score);
  }

  function show(box, panel, list, count) {
    const words = plain(box.value).split(/[\s,;]+/).filter(word => word.length > 1);
    panel.hidden = !words.length;
    if (!words.length) return;
    if (!index) {
      count.textContent = 'Reading the words of all pages';
      load().then(() => show(box, panel, list, count), () => (count.textContent = 'The words of the pages are not beside them: shared/words.js'));
      return;
    }
    const found = search(words);
    list.replaceChildren(
      ...found.slice(0, MOST_PAGES).map(({ path, title, best }) =>
        make('li', {},
          make('a', { href: `${root}${path}${best[0].name ? `#${best[0].name}` : ''}` }, title),
          make('ul', {},
            ...best
              .filter(place => place.title && place.title !== title)
              .slice(0, MOST_PLACES)
              .map(place => make('li', {}, make('a', { href: `${root}${path}#${place.name}` }, place.title))),
          ),
        ),
      ),
    );
    const noun = isFolder ? 'page' : 'part';
    count.textContent = `${found.length || 'No'} ${noun}${found.length === 1 ? ' has' : 's have'} ${words.length === 1 ? 'this word' : 'these words'}${
      found.length > MOST_PAGES ? `, the first ${MOST_PAGES}:` : ''
    }`;
  }

  // An address may name a part that has moved to a page of its own.
  async function goHome() {
    const name = decodeURIComponent(location.hash.slice(1));
    if (!name || document.getElementById(name) || !isFolder) return;
    await load();
    const place = index.places.find(([, known]) => known === name);
    if (place) location.replace(`${root}${index.pages[place[0]][0]}#${name}`);
  }

  document.addEventListener('DOMContentLoaded', () => {
    const [box, panel, list, count] = ['search', 'found', 'found-list', 'found-count'].map(name => document.getElementById(name));
    addEventListener('hashchange', goHome);
    goHome();
    if (!box) return;
    const update = () => show(box, panel, list, count);
    box.addEventListener('focus', () => load().catch(() => {}), { once: true });
    box.addEventListener('input', update);
    box.addEventListener('keydown', event => {
      if (event.key === 'Escape') {
        box.value = '';
        update();
      }
      if (event.key === 'Enter' && !panel.hidden) list.querySelector('a')?.click();
    });
    document.addEventListener('click', event => {
      if (!event.target.closest('.search') || event.target.closest('#found a')) panel.hidden = true;
    });
    box.addEventListener('click', update);
    document.addEventListener('keydown', event => {
      if (event.key === '/' && !event.target.closest('input, textarea, select')) {
        event.preventDefault();
        box.focus();
      }
    });
  });

  return { take: words => (index = words) };
})();
