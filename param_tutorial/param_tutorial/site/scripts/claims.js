/* The page of claims: a choice of which verdicts its tables show. */

import {all, make, one} from '../../../param_tools/panel/dom.js';

const ALL = 'all claims';

/** @param {HTMLTableRowElement} row */
const verdictOf = row => (row.cells[2]?.textContent ?? '').split(':')[0].trim();

/** Put the choice above the tables, if the page has claims. */
export function beginClaims() {
  const rows = all(document, '.bd-article tbody tr', HTMLTableRowElement).filter(row =>
    /^A\d{3}$/.test(row.cells[0].textContent?.trim() ?? ''),
  );
  if (!rows.length) return;
  const verdicts = [ALL, ...new Set(rows.map(verdictOf))];
  const choice = make('select', {}, ...verdicts.map(each => make('option', {}, each)));
  const count = make('span', {});
  count.setAttribute('role', 'status');
  choice.addEventListener('change', () => {
    for (const row of rows) row.hidden = choice.value !== ALL && verdictOf(row) !== choice.value;
    count.textContent = `${rows.filter(row => !row.hidden).length} of ${rows.length} claims`;
  });
  const line = make('p', {className: 'lesson-filter'}, make('label', {}, 'Show ', choice), count);
  one(document, '.bd-article h1').after(line);
}
