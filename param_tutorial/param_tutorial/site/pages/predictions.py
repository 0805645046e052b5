"""Draws a prediction as a form of the page, which answers without a kernel: ``site/scripts/predictions.js``."""

from collections.abc import Callable

from param_tools.markup.tables import with_code
from param_tutorial.exercises.predicting import STYLE, draw_question, verdict
from param_tutorial.exercises.prediction import ASK_AGAIN, NUMBER, Prediction, wrong
from param_tutorial.site.pages.drawing import json_in_script


def draw_prediction(prediction: Prediction, linked: Callable[[str], str]) -> str:
    """Return the HTML of a prediction: a form that says what became of the answer, as soon as there is one.

    :param linked: Returns a verdict with the page's links in it.
    """
    facts = json_in_script({
        'choices': {prediction.plain(each.text): linked(verdict(prediction, each)) for each in prediction.choices},
        'right': [prediction.plain(each.text) for each in prediction.choices if each.is_right],
        # A typed number may be none of the choices; the page's script reads it as the notebook does.
        'typed': {'number': NUMBER, 'askAgain': with_code(ASK_AGAIN),
                  'otherwise': linked(verdict(prediction, wrong('', prediction.otherwise)))}
        if prediction.is_typed else None,
    })
    return (f'{STYLE}<form class="lesson-prediction param-predict" autocomplete="off" '
            f'data-number="{prediction.number}" '
            # A recall comes again; the first page links to it then.
            f'{"data-decided" if prediction.is_decided_by_a_cell else f"id=recall-{prediction.number}"}>'
            f'{draw_question(prediction)}'
            f'<button type="submit" class="lesson-commit param-predict-commit" disabled>Commit</button>'
            f'<p class="lesson-says" role="status"></p>'
            f'<button type="button" class="lesson-again" hidden>Answer again</button>'
            f'<script type="application/json">{facts}</script></form>')
