/* All scripts of a page of the website. */

import {beginLive} from '../live/page.js';
import {beginClaims} from './claims.js';
import {beginLesson} from './lesson.js';
import {beginSearch} from './search.js';

for (const begin of [beginLesson, beginLive, beginClaims, beginSearch]) {
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin);
  else begin();
}
