// Compiles the modules in a folder with Pyodide, in Node.js: node compile.mjs PYODIDE FOLDER
const [pyodide, folder] = process.argv.slice(2);
const { loadPyodide } = await import(`${pyodide}/pyodide.mjs`);
const python = await loadPyodide({ indexURL: pyodide });
python.FS.mkdirTree("/modules");
python.FS.mount(python.FS.filesystems.NODEFS, { root: folder }, "/modules");
// A file in a page is as old as its arrival, so a digest stands in place of the time, and is not looked at.
python.runPython(`
import compileall, py_compile
compileall.compile_dir('/modules', quiet=2, invalidation_mode=py_compile.PycInvalidationMode.UNCHECKED_HASH)
`);
process.exit(0);
