// Runs the code cells of a notebook in the kernel of a web page, in Node.js, and prints their outputs as JSON:
//     node page_kernel.mjs FOLDER NOTEBOOK
// FOLDER holds what the page loads. What happens here is what the worker of JupyterLite's kernel does, as far as it has
// to do with Python. The notebook's folder is what the page shows as its files.
import fs from "node:fs";
import path from "node:path";

const [folder, notebook] = process.argv.slice(2);
const { loadPyodide } = await import(path.resolve(folder, "pyodide.mjs"));
const lock = JSON.parse(fs.readFileSync(path.join(folder, "pyodide-lock.json"), "utf8"));
const say = (text) => process.stderr.write(`${text}\n`);
const python = await loadPyodide({ indexURL: folder, packages: Object.keys(lock.packages), stdout: say, stderr: say });
python.FS.mkdirTree("/drive");
// A copy, so that nothing is written into the checkout.
const given = path.dirname(notebook);
for (const name of fs.readdirSync(given)) {
  if (fs.statSync(path.join(given, name)).isFile()) {
    python.FS.writeFile(`/drive/${name}`, fs.readFileSync(path.join(given, name)));
  }
}
python.FS.chdir("/drive");
await python.runPythonAsync("import pyodide_kernel");
// The stored outputs are those of somebody whose progress is not kept.
python.runPython("import os; os.environ.pop('PARAM_TUTORIAL_PROGRESS')");
const { kernel_instance: kernel, ipython_shell: shell, stdout_stream, stderr_stream } =
  python.pyimport("pyodide_kernel");

const plain = (value) =>
  value instanceof python.ffi.PyProxy ? value.toJs({ dict_converter: Object.fromEntries }) : value;
let outputs = [];
const displays = new Map();
const publish = (name, text) => outputs.push({ output_type: "stream", name, text });
const show = (data, metadata, transient) => {
  const output = { output_type: "display_data", data: plain(data), metadata: plain(metadata) ?? {} };
  outputs.push(output);
  displays.set(plain(transient)?.display_id, output);
};
const update = (data, metadata, transient) => {
  const output = displays.get(plain(transient)?.display_id);
  if (output) {
    Object.assign(output, { data: plain(data), metadata: plain(metadata) ?? {} });
  }
};
stdout_stream.publish_stream_callback = publish;
stderr_stream.publish_stream_callback = publish;
shell.display_pub.clear_output_callback = () => outputs.splice(0);
shell.display_pub.display_data_callback = show;
shell.display_pub.update_display_data_callback = update;
shell.displayhook.publish_execution_result = (execution_count, data, metadata) =>
  outputs.push({ output_type: "execute_result", execution_count, data: plain(data), metadata: plain(metadata) });
shell.send_comm = () => {};

const results = [];
for (const [position, cell] of JSON.parse(fs.readFileSync(notebook, "utf8")).cells.entries()) {
  if (cell.cell_type !== "code") {
    continue;
  }
  outputs = [];
  kernel._parent_header = python.toPy({ header: { msg_id: `${position}` }, metadata: { cellId: cell.id } });
  const result = plain(await kernel.run([cell.source].flat().join("")));
  if (result.status === "error") {
    // This kernel says "<class 'package.Name'>" where others say "Name".
    const ename = result.ename.match(/(\w+)'>$/)[1];
    outputs.push({ output_type: "error", ename, evalue: result.evalue, traceback: plain(result.traceback) });
  }
  results.push(outputs);
}
process.stdout.write(JSON.stringify(results), () => process.exit(0));
