// Runs before anything is drawn: a page chosen to be dark must not flash white first.
'use strict';
const theme = {
  key: 'plumbline-theme',
  // Storage may be refused (private windows, pages opened from a file): the choice then lasts as long as the page.
  stored() {
    try {
      return localStorage.getItem(this.key);
    } catch {
      return null;
    }
  },
  store(name) {
    try {
      localStorage.setItem(this.key, name);
    } catch {
      /* nothing to keep it in */
    }
  },
  get dark() {
    const chosen = document.documentElement.dataset.theme;
    return chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  },
  choose(name) {
    document.documentElement.dataset.theme = name;
  },
};
document.documentElement.classList.add('js');
if (['dark', 'light'].includes(theme.stored())) theme.choose(theme.stored());
