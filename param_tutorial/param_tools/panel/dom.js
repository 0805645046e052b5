/* What the scripts need of a page's elements. */

/**
 * Return the first element that a selector finds, which has to be there.
 * @template {Element} [T=HTMLElement]
 * @param {ParentNode} root
 * @param {string} selector
 * @param {new () => T} [kind]
 */
export function one(root, selector, kind = /** @type {any} */ (HTMLElement)) {
  const found = root.querySelector(selector);
  if (!(found instanceof kind)) throw new TypeError(`There is no ${kind.name} ${selector} on the page.`);
  return found;
}

/**
 * Return all elements of a kind that a selector finds.
 * @template {Element} [T=HTMLElement]
 * @param {ParentNode} root
 * @param {string} selector
 * @param {new () => T} [kind]
 * @returns {T[]}
 */
export function all(root, selector, kind = /** @type {any} */ (HTMLElement)) {
  return /** @type {T[]} */ ([...root.querySelectorAll(selector)].filter(each => each instanceof kind));
}

/**
 * Return a new element.
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag
 * @param {Partial<HTMLElementTagNameMap[T]>} [properties]
 * @param {...(string | Node)} content
 */
export function make(tag, properties = {}, ...content) {
  const made = document.createElement(tag);
  Object.assign(made, properties);
  made.append(...content);
  return made;
}

/**
 * Return what has the focus on the page, or in the shadow root, of an element.
 * @param {Element} element
 */
export function focusedBeside(element) {
  return /** @type {Document | ShadowRoot} */ (element.getRootNode()).activeElement;
}

/**
 * Follow the pointer until it is let go.
 * @param {(event: PointerEvent) => void} move
 * @param {(event: PointerEvent) => void} [end]
 */
export function followPointer(move, end) {
  const ended = new AbortController();
  const {signal} = ended;
  document.addEventListener('pointermove', move, {signal});
  for (const kind of /** @type {const} */ (['pointerup', 'pointercancel'])) {
    document.addEventListener(
      kind,
      event => {
        ended.abort();
        end?.(event);
      },
      {signal},
    );
  }
}

/** Return a name that no other script on the page has. Each view has its scripts for itself, so counting would not do. */
export function uniqueName() {
  return Math.random().toString(36).slice(2);
}
