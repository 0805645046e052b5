/* Reads what a Python value looks like, as far as the exercises have them. */

/**
 * Return a value as Python shows it, and its type; null if the text is none.
 * @param {string} typed
 * @returns {{text: string, type: string, value?: string} | null}
 */
export function readPythonValue(typed) {
  const text = typed.trim();
  if (text === '' || text === '...') return {text: '', type: ''};
  if (text === 'True' || text === 'False') return {text, type: 'bool'};
  if (text === 'None') return {text, type: 'NoneType'};
  if (/^[-+]?\d+(_\d+)*$/.test(text)) return readInteger(text);
  if (/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text)) return {text: formatFloat(Number(text)), type: 'float'};
  const quoted = /^(['"])((?:(?!\1|\\).)*)\1$/.exec(text);
  if (quoted) {
    const mark = quoted[2].includes("'") && !quoted[2].includes('"') ? '"' : "'";
    return {text: `${mark}${quoted[2]}${mark}`, type: 'str', value: quoted[2]};
  }
  const listed = /^\[(.*)\]$|^\((.*)\)$/s.exec(text);
  return listed && readList((listed[1] ?? listed[2]).trim().replace(/,$/, ''));
}

/** @param {string} text */
function readInteger(text) {
  // Python knows no number that begins with 0.
  return /^[-+]?0+[1-9]/.test(text) ? null : {text: String(BigInt(text.replace(/[+_]/g, ''))), type: 'int'};
}

/** @param {number} number */
function formatFloat(number) {
  if (Object.is(number, -0)) return '-0.0';
  return Number.isInteger(number) && Math.abs(number) < 1e16 ? number.toFixed(1) : String(number);
}

/** @param {string} inner */
function readList(inner) {
  const parts = inner === '' ? [] : inner.match(/(?:"[^"]*"|'[^']*'|[^,"'])+/g);
  const values = parts?.map(readPythonValue);
  if (!values?.every(each => each?.type)) return null;
  return {text: `[${values.map(each => each?.text).join(', ')}]`, type: 'list'};
}
