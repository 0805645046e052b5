/* All scripts of a page of the website. */

import {beginLive} from '../live/page.js';
import {beginLesson} from './lesson.js';

for (const begin of [beginLesson, beginLive]) {
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin);
  else begin();
}
