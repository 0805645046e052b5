/* A lesson for a lecture: large, without what a teacher says in their own words, and with its code folded. What stays are
   headings, pictures, panels, outputs, questions and exercises. */

import {all, make} from '../../../param_tools/panel/dom.js';

/** Put a button into the header that makes the page large, and makes it as it was. */
export function offerProjector() {
  const root = document.documentElement;
  for (const tools of all(document, '.lesson-tools')) {
    const button = make(
      'button',
      {type: 'button', title: 'For a lecture: large, with folded code and without the text'},
      'Projector',
    );
    button.setAttribute('aria-pressed', 'false');
    button.addEventListener('click', () => {
      const middle = document.elementFromPoint(innerWidth / 2, innerHeight / 2)?.closest('.bd-article section, .cell');
      const isOn = root.toggleAttribute('data-projector');
      for (const each of all(document, '.lesson-tools button')) each.setAttribute('aria-pressed', String(isOn));
      middle?.scrollIntoView({block: 'start'});
    });
    tools.append(button);
  }
}
