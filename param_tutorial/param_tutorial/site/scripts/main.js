/* All scripts of a page of the website. */

import {beginGlossary} from './glossary.js';
import {beginLesson} from './lesson.js';
import {beginSearch} from './search.js';

for (const begin of [beginLesson, beginGlossary, beginSearch]) {
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin);
  else begin();
}
