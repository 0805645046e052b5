"""Modules joined to one script for the browser; that the script works is tested in the browser."""

import re

import pytest

from param_tools.markup import scripts
from param_tools.markup.scripts import bundle


@pytest.fixture
def modules(monkeypatch):
    """Return a dictionary of modules that stand in for those of the package."""
    files = {}
    monkeypatch.setattr(scripts, 'sheet', files.__getitem__)
    return files


def test_each_module_comes_once_and_before_those_that_import_it(modules):
    modules |= {
        'a/entry.js': "import {two} from './two.js';\nimport {\n  one,\n} from '../b/one.js';\nexport default {two};",
        'a/two.js': "import {one} from '../b/one.js';\nexport async function two() {}\nexport const three = one;",
        'b/one.js': 'const own = 1;\nexport class one {}'}
    text = bundle('a/entry.js')
    assert re.findall(r'^const (\S+) = \(\(\) =>', text, re.MULTILINE) == ['b_one_js', 'a_two_js']
    assert re.findall(r'return (.*);\n\}\)', text) == ['{one}', '{two, three}']
    assert text.endswith('const {two} = a_two_js;\nconst {\n  one,\n} = b_one_js;\nexport default {two};')
    assert text.count('export ') == 1


@pytest.mark.parametrize('line', [
    "import * as dom from './dom.js';", "import './dom.js';", "import dom from 'dom';", 'export let count = 0;',
    'export {count};', 'export default count;'])
def test_a_form_of_import_or_export_that_is_unknown_is_an_error(modules, line):
    modules |= {'entry.js': "import {a} from './a.js';", 'a.js': f'export const a = 1;\n{line}'}
    with pytest.raises(ValueError, match=rf'^a\.js: .*: {re.escape(line)}$'):
        bundle('entry.js')
