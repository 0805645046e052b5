/* The kernel of a page: runs cells in Pyodide, and says what they put out and what becomes of their widgets.

   The same in the worker of a page (`worker.js`) and, when the site is built, in Node.js (`run.mjs`), so that a page
   can be asked whether it says what was said when it was made. Widgets go by names that are the same in both: the cell
   that made one, the how-manieth run of the cell, and a number. */

/**
 * What the kernel says: that it begins with a cell; an output of a cell; that an earlier output is another one now, or that all before are to go;
 * what a widget has become; what a node has logged; which exercises are solved;
 * and how a cell has ended.
 * @typedef {{is: 'begin', cell: string} | {is: 'output', cell: string, output: any} | {is: 'update', display: string, output: any} |
 *   {is: 'clear', cell: string, wait: boolean} | {is: 'widget', does: string, name: string, state?: any, content?: any} |
 *   {is: 'log', time_ms: number, text: string} |
 *   {is: 'solved', numbers: string[]} | {is: 'ran', cell: string, status: string}} Said
 */

/** In an output of a cell: the widget that it shows. */
export const WIDGET = 'application/vnd.jupyter.widget-view+json';
/** The file in which the course keeps what the learner has solved. */
export const PROGRESS = '/drive/progress.json';
const SITE = '/lib/python3.14/site-packages/';
// Nobody types into a terminal here, and what IPython would load for one takes a second. Nothing waits for an answer, either.
const PREPARE = `
  import builtins, os, sys, types
  embed = sys.modules['IPython.terminal.embed'] = types.ModuleType('IPython.terminal.embed')
  embed.embed = None
  os.makedirs('/drive', exist_ok=True)
  os.chdir('/drive')
  import pyodide_kernel
  from IPython.core.error import StdinNotImplementedError

  def no_input(*_):
      raise StdinNotImplementedError("input() can't ask in a web page: write the answer into the cell, e.g. answer = 'yes'")

  builtins.input = no_input
`;

// From the first executor on.
const FOLLOW_LOG = `
  import contextlib
  from param_tools.errors import ExecutorError
  from param_tools.ros import stage

  def follow_log(tell):
      def begin():
          with contextlib.suppress(ExecutorError):  # it was stopped
              stage.current().node_log.on_line(lambda line: tell(line.time_ns / 1e6, str(line)))
      stage.on_change(begin)

  follow_log
`;

const SETTLE = `
  from param_tools.ros import host
  lambda: host.host.settle()
`;

/**
 * Return files that are in one, by their names: names and lengths as JSON on the first line, and then all contents.
 * @param {Uint8Array<ArrayBuffer>} joined
 */
export function filesIn(joined) {
  const end = joined.indexOf(10);
  let at = end + 1;
  /** @type {Record<string, Uint8Array<ArrayBuffer>>} */
  const files = {};
  for (const [name, length] of JSON.parse(new TextDecoder().decode(joined.subarray(0, end)))) {
    files[name] = joined.subarray(at, at + length);
    at += length;
  }
  return files;
}

/**
 * Put packages where Python finds them.
 * @param {any} python
 * @param {Uint8Array<ArrayBuffer>} packages
 */
export function install(python, packages) {
  for (const [name, content] of Object.entries(filesIn(packages))) {
    const path = name.startsWith('/') ? name : SITE + name;
    python.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    python.FS.writeFile(path, content, {canOwn: true});
  }
}

/**
 * Return a short text that differs for different outputs, whatever else differs from run to run.
 * @param {any[]} outputs
 */
export function digest(outputs) {
  /** @type {any[]} */
  const parts = [];
  for (const {output_type, name, text, data, ename, evalue} of outputs) {
    const last = parts.at(-1);
    if (output_type === 'stream' && last && last[0] === name) last[1] += text;
    else if (output_type === 'stream') parts.push([name, text]);
    else parts.push([ename ?? '', evalue ?? data?.['text/html'] ?? data?.['text/plain']]);
  }
  let hash = 0;
  for (const letter of JSON.stringify(parts)) hash = (Math.imul(hash, 31) + (letter.codePointAt(0) ?? 0)) | 0;
  return hash.toString(36);
}

// A message for each of 200,000 prints would leave a page no time to draw. So many are told one by one; what comes
// after them without a pause goes together.
const PRINTS = 1000;
const PAUSE_MS = 50;

/** Runs cells, one after the other. */
export class Kernel {
  /** The id of the cell that runs, or ran last: as in ipykernel, what a callback prints later belongs to it. */
  cell = '';
  /** @type {Map<string, number>} */
  runs = new Map();
  count = 0;
  /** Names of widgets by ids of comms, and the other way round. @type {Map<string, string>} */
  names = new Map();
  /** @type {Map<string, string>} */
  comms = new Map();
  /** What is printed and not told yet. */
  printed = {name: '', text: ''};
  prints = 0;
  toldAt = 0;

  /**
   * @param {any} python Pyodide, with the packages.
   * @param {(said: Said) => void} say
   */
  constructor(python, say) {
    this.python = python;
    this.post = say;
    python.runPython(PREPARE);
    const {kernel_instance, ipython_shell, stdout_stream, stderr_stream} = python.pyimport('pyodide_kernel');
    this.kernel = kernel_instance;
    this.settle = python.runPython(SETTLE);
    python.runPython(FOLLOW_LOG)((/** @type {number} */ time_ms, /** @type {string} */ text) =>
      this.say({is: 'log', time_ms, text}),
    );
    const output = (/** @type {any} */ content) => this.say({is: 'output', cell: this.cell, output: content});
    const print = (/** @type {string} */ name, /** @type {string} */ text) => this.print(name, text);
    stdout_stream.publish_stream_callback = print;
    stderr_stream.publish_stream_callback = print;
    const {display_pub, displayhook} = ipython_shell;
    display_pub.clear_output_callback = (/** @type {boolean} */ wait) => this.say({is: 'clear', cell: this.cell, wait});
    display_pub.display_data_callback = (/** @type {any} */ data, /** @type {any} */ _, /** @type {any} */ transient) =>
      output({output_type: 'display_data', data: this.data(data), display: this.plain(transient)?.display_id});
    display_pub.update_display_data_callback = (
      /** @type {any} */ data,
      /** @type {any} */ _,
      /** @type {any} */ how,
    ) => this.say({is: 'update', display: this.plain(how)?.display_id, output: {data: this.data(data)}});
    displayhook.publish_execution_result = (/** @type {number} */ _, /** @type {any} */ data) =>
      output({output_type: 'execute_result', data: this.data(data)});
    ipython_shell.send_comm = (/** @type {string} */ type, /** @type {any} */ content) =>
      this.hear(type, this.plain(content));
  }

  /** @param {Said} said */
  say(said) {
    this.tellPrinted();
    this.post(said);
  }

  /**
   * @param {string} name Of the stream.
   * @param {string} text
   */
  print(name, text) {
    if (this.printed.name !== name) this.tellPrinted();
    const isPaused = performance.now() - this.toldAt > PAUSE_MS;
    const isFirst = !this.printed.text;
    if (isFirst && isPaused) this.prints = 0;
    this.printed = {name, text: this.printed.text + text};
    this.prints += 1;
    if (isPaused || this.prints <= PRINTS) this.tellPrinted();
    else if (isFirst) setTimeout(() => this.tellPrinted());
  }

  /** Tell what was printed, if anything. */
  tellPrinted() {
    const {name, text} = this.printed;
    if (!text) return;
    this.printed = {name: '', text: ''};
    this.toldAt = performance.now();
    this.post({is: 'output', cell: this.cell, output: {output_type: 'stream', name, text}});
  }

  /** @param {any} value */
  plain(value) {
    return value instanceof this.python.ffi.PyProxy ? value.toJs({dict_converter: Object.fromEntries}) : value;
  }

  /**
   * Return the data of an output, with the widget's name in the place of its id.
   * @param {any} given
   */
  data(given) {
    const data = this.plain(given);
    const view = data[WIDGET];
    if (view) view.model_id = this.names.get(view.model_id);
    return data;
  }

  /**
   * @param {string} type
   * @param {any} content
   */
  hear(type, {comm_id, data}) {
    if (type === 'comm_open') {
      const name = `${this.cell}/${this.runs.get(this.cell) ?? 0}/${this.count++}`;
      this.names.set(comm_id, name);
      this.comms.set(name, comm_id);
    }
    const name = this.names.get(comm_id) ?? '';
    if (type === 'comm_close') {
      this.say({is: 'widget', does: 'close', name});
      this.comms.delete(name);
    } else if (data.state) {
      this.say({is: 'widget', does: type === 'comm_open' ? 'open' : 'update', name, state: this.named(data.state)});
    } else if (data.method === 'custom') {
      this.say({is: 'widget', does: 'custom', name, content: data.content});
    }
  }

  /**
   * Return a state in which widgets go by their names.
   * @param {any} state
   */
  named(state) {
    return JSON.parse(JSON.stringify(state), (_, value) =>
      typeof value === 'string' && value.startsWith('IPY_MODEL_')
        ? `IPY_MODEL_${this.names.get(value.slice('IPY_MODEL_'.length))}`
        : value,
    );
  }

  /**
   * @param {string} cell Its id.
   * @param {string} code
   */
  async run(cell, code) {
    this.cell = cell;
    this.count = 0;
    const run = (this.runs.get(cell) ?? 0) + 1;
    this.runs.set(cell, run);
    this.say({is: 'begin', cell});
    const header = {header: {msg_id: `${cell}/${run}`}, metadata: {cellId: cell}};
    this.kernel._parent_header = this.python.toPy(header);
    const {status, ename, evalue, traceback} = this.plain(await this.kernel.run(code));
    if (status === 'error') {
      // This kernel says "<class 'package.Name'>" where others say "Name".
      const name = /(\w+)'>$/.exec(ename)?.[1] ?? ename;
      const output = {output_type: 'error', ename: name, evalue, traceback: this.plain(traceback)};
      this.say({is: 'output', cell, output});
    }
    this.tellSolved();
    this.say({is: 'ran', cell, status});
  }

  /** Say which exercises the course knows as solved, if it keeps that. */
  tellSolved() {
    const {FS} = this.python;
    if (!FS.analyzePath(PROGRESS).exists) return;
    const {solved} = JSON.parse(FS.readFile(PROGRESS, {encoding: 'utf8'}));
    this.say({is: 'solved', numbers: Object.keys(solved)});
  }

  /**
   * Tell a widget what a hand did.
   * @param {string} name
   * @param {any} data As a comm's message has it.
   */
  tell(name, data) {
    const comm_id = this.comms.get(name);
    if (!comm_id) return;
    const message = this.python.toPy({header: {}, metadata: {}, buffers: [], content: {comm_id, data}});
    this.kernel.comm_manager.comm_msg(null, null, message);
    message.destroy();
    // Or the answer would wait for the next turn between the cells.
    this.settle();
  }
}
