// Runs the code cells of a notebook in the kernel of a page, in Node.js, and prints what it says to each as JSON:
//     node run.mjs PYODIDE PACKAGES KERNEL NOTEBOOK [rest]
// KERNEL is kernel.js as a module by itself, and PACKAGES what it installs. With `rest` it waits after each cell until what
// moves has come to rest.
import fs from "node:fs";
import path from "node:path";

const [pyodide, packages, kernel, notebook] = process.argv.slice(2, 6).map((each) => path.resolve(each));
const isToRest = process.argv[6] === "rest";
// Its parent process is gone.
process.stdin.resume().on("end", () => process.exit(1));
const { loadPyodide } = await import(path.join(pyodide, "pyodide.mjs"));
const { digest, install, Kernel, WIDGET } = await import(kernel);
const python = await loadPyodide({ indexURL: pyodide, stdout: console.error, stderr: console.error });
install(python, new Uint8Array(fs.readFileSync(packages)));

let said = [];
let heardAt = 0;
const page = new Kernel(python, (each) => {
  // A node may log every second; its page shows that, and nothing moves.
  if (each.is === "log") return;
  heardAt = performance.now();
  said.push(each);
});
// The stored outputs are those of somebody whose progress is not kept.
python.runPython("import os; os.environ.pop('PARAM_TUTORIAL_PROGRESS')");

// What moves has come to rest when nothing was heard for so long: more than the longest phase of a drive, and than an answer
// of a node takes on a busy machine.
const QUIET_MS = 4500;
async function rest() {
  while (performance.now() - heardAt < QUIET_MS) {
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

const results = [];
for (const cell of JSON.parse(fs.readFileSync(notebook, "utf8")).cells) {
  if (cell.cell_type === "code") {
    said = [];
    await page.run(cell.id, [cell.source].flat().join(""));
    const outputs = said.filter((each) => each.is === "output").map((each) => each.output);
    const known = digest(outputs);
    // Only what is live goes on after its cell.
    if (isToRest && said.some((each) => each.output?.data?.[WIDGET])) {
      await rest();
    }
    results.push({ cell: cell.id, outputs, said, digest: known });
  }
}
process.stdout.write(JSON.stringify(results), () => process.exit(0));
