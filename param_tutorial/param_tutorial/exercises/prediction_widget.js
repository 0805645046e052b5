/* A prediction in JupyterLab: the form asks, and the kernel says what became of the answer; see `predicting.py`. */

import {all, one} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';
import {markChoices} from './marks.js';

/**
 * @import {RenderProps} from '@anywidget/types'
 * @typedef {{markup: string, answer: string, is_committed: boolean, said: string, right: string}} Traits
 */

/** @param {RenderProps<Traits>} props */
function render({model, el}) {
  el.innerHTML = model.get('markup');
  const form = one(el, 'form', HTMLFormElement);
  const fields = one(form, 'fieldset', HTMLFieldSetElement);
  const boxes = all(form, 'input', HTMLInputElement);
  const commit = one(form, '.param-predict-commit', HTMLButtonElement);
  const said = one(form, '.param-predict-says');
  const given = () => String(new FormData(form).get('answer') ?? '').trim();

  form.addEventListener('input', () => {
    model.set('answer', given());
    model.save_changes();
    commit.disabled = !given();
  });
  form.addEventListener('submit', event => {
    event.preventDefault();
    if (given()) model.send({do: 'commit', answer: given()});
  });
  fields.addEventListener('keydown', event => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    form.requestSubmit(); // JupyterLab keeps the browser from it
  });
  one(form, '.param-predict-skip').addEventListener('click', () => model.send({do: 'skip'}));

  function show() {
    const answer = model.get('answer');
    for (const box of boxes) {
      if (box.type === 'radio') box.checked = box.value === answer;
      else if (box.value.trim() !== answer) box.value = answer;
    }
    const isCommitted = model.get('is_committed');
    // The button keeps the focus, from which Shift+Enter goes on to the next cell; what is disabled would lose it.
    if (isCommitted && fields.contains(document.activeElement)) commit.focus();
    fields.disabled = isCommitted;
    commit.disabled = !isCommitted && !answer;
    commit.textContent = isCommitted ? 'Committed' : 'Commit';
    commit.classList.toggle('param-predict-committed', isCommitted);
    if (said.innerHTML !== model.get('said')) said.innerHTML = model.get('said');
    markChoices(form, model.get('right'));
  }

  show();
  model.on('change', show);
}

export default {initialize, render};
