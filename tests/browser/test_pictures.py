"""Pictures on pages of all widths: no letter is too small to read, and none is cut off."""

import pytest

from param_tutorial.views.drawing import svg
from tests.views.examples import DIAGRAMS, EXAMPLES

# For each drawing: how large its smallest letters are in px, and what is cut off.
LOOK = '''() => [...document.querySelectorAll('svg:has(text)')].map(drawing => {
  const frame = drawing.getBoundingClientRect();
  const scale = frame.width / drawing.viewBox.baseVal.width;
  const texts = [...drawing.querySelectorAll('text')].filter(each => each.textContent);
  return [
    Math.min(...texts.map(each => parseFloat(getComputedStyle(each).fontSize) * scale)),
    texts.filter(each => {
      const {left, right} = each.getBoundingClientRect();
      return drawing.closest('.motion') && (left < frame.left - 1 || right > frame.right + 1);
    }).map(each => each.textContent).join(),
  ];
})'''


@pytest.mark.parametrize('width', [320, 440, 728, 1280])
def test_no_letter_is_smaller_than_11_px_or_cut_off(browser, width):
    page = browser.new_page(viewport={'width': width, 'height': 900}, reduced_motion='reduce')
    pictures = [EXAMPLES[name] for name in DIAGRAMS]
    page.set_content(f'{svg.STYLE}<div>{"</div><div>".join(pictures)}</div>')
    looks = page.evaluate(LOOK)
    assert len(looks) > 10
    assert [look for look in looks if look[0] < 10.99 or look[1]] == []
    page.close()
