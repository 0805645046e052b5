/* How an answer to a prediction is read and compared: see `exercises/prediction.py`. */

/**
 * @typedef {object} Facts What to say to each answer, as HTML, and which answers are right.
 * @property {Record<string, string>} choices
 * @property {string[]} right
 * @property {{number: string, askAgain: string, otherwise: string} | null} typed Where a number is typed: its pattern,
 *   what is said to anything else, and to any other number.
 */

/**
 * Return the number in a typed answer; NaN if there is none.
 * @param {string} answer
 * @param {string} pattern The one of `exercises/prediction.py`.
 */
export function parseNumber(answer, pattern) {
  const [, grouped, plain] = new RegExp(pattern, 'u').exec(answer.trim()) ?? [];
  return Number(grouped?.replaceAll(',', '') ?? plain?.replace(',', '.'));
}

/**
 * Return that of the choices that an answer is; undefined if it is none.
 * @param {string} answer
 * @param {Facts} facts
 */
export function choiceOf(answer, {choices, typed}) {
  const number = typed && parseNumber(answer, typed.number);
  return Object.keys(choices).find(each => (typed ? Number(each) === number : each === answer.toLowerCase()));
}
