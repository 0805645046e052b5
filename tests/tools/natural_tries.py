"""What a class of thirty would try on the website's panels, and how much of it the pages answer.

    .venv/bin/python -m tests.tools.natural_tries build/html

Each line is one visit to a page: what is typed, pulled, ticked and driven there, one after another. A visit is answered
if nothing on the page says "Not recorded" afterwards, and no picture is dimmed.
"""

import sys
from pathlib import Path

from playwright.sync_api import Page

from tests.support.lab import chromium

# `name=text` types, `name~0.7` pulls a slider to that part of its way, `name!` clicks a check box, `drive` drives.
# A number in brackets after the page's name says which of its panels is meant, from 0.
TRIES = {
    'index': '''
        max_acceleration_mps2~0.8 drive
        max_acceleration_mps2~0.1 drive
        max_acceleration_mps2~1 enable_safety_mode! drive
        max_acceleration_mps2~0.37 enable_safety_mode! drive
        enable_safety_mode! drive
        max_speed_rpm~0.5 drive
        max_speed_rpm~1 max_acceleration_mps2~1 drive
        max_speed_rpm=200 enable_safety_mode! drive
        max_acceleration_mps2=1.5 max_speed_rpm=250 enable_safety_mode! drive
    ''',
    '01_what_are_parameters': '''
        max_acceleration_mps2=1.0 drive
        max_acceleration_mps2=0.25 drive
        max_acceleration_mps2=.5 drive
        max_acceleration_mps2=2 drive
        max_acceleration_mps2=0.01 drive
        max_acceleration_mps2=0.33 drive
        max_acceleration_mps2=5
        max_acceleration_mps2=-1
        max_acceleration_mps2=0
        max_acceleration_mps2=fast
        max_acceleration_mps2=hello
        max_speed_rpm=150 drive
        max_speed_rpm=12.5
        max_speed_rpm=0 drive
        max_speed_rpm=75 drive
        max_speed_rpm=-50
        max_speed_rpm=1000
        max_speed_rpm=ten
        max_speed_rpm=
        enable_safety_mode! max_speed_rpm=300 drive
        enable_safety_mode! max_acceleration_mps2=1.0 drive
        enable_safety_mode! max_acceleration_mps2=0.1 max_speed_rpm=50 drive
        max_acceleration_mps2=1.5 max_speed_rpm=200 drive
        max_acceleration_mps2~0.63 max_speed_rpm~0.41 drive
    ''',
    '01_what_are_parameters[3]': '''
        max_acceleration_mps2=1.0 drive
        enable_safety_mode! drive
        max_speed_rpm=50 enable_safety_mode! drive
    ''',
    '01_what_are_parameters[6]': '''
        simulation.ambient_temperature_c=-10 drive
        min_operating_temperature_c=20 drive
        min_operating_temperature_c=-20 simulation.ambient_temperature_c=-20 drive
        sensor_offset_meters=0.5 drive
        sensor_offset_meters~0 drive
        sensor_offset_meters=-0.3 enable_safety_mode! drive
        robot_name=Rex drive
        robot_name=Rex max_speed_rpm~0.5 drive
        robot_name=
        max_speed_rpm=100 max_acceleration_mps2~0.75 drive
        sensor_offset_meters~0.9 max_acceleration_mps2~0.9 drive
        simulation.ambient_temperature_c~0.2 drive
    ''',
    '05_2_with_a_callback': '''
        max_speed_rpm=-1
        max_speed_rpm=-50
        max_speed_rpm=150
        max_speed_rpm=100000
        max_speed_rpm=12.5
        max_speed_rpm=fast
        max_speed_rpm=0
        robot_name=Rex
        robot_name=
        robot_name=Robbie
        robot_name=hello
        sensor_offset_meters=.5
        sensor_offset_meters=1
        sensor_offset_meters=hello
        max_acceleration_mps2=3
        max_acceleration_mps2~0.6
        min_operating_temperature_c=-30
        min_operating_temperature_c~0.5 max_speed_rpm=-7
        enable_safety_mode! max_speed_rpm=200
        robot_name=Wall-E max_speed_rpm=120
    ''',
    '06_1_descriptors_and_ranges': '''
        opening_mm=45
        opening_mm=85
        opening_mm=90
        opening_mm=-10
        opening_mm=12.5
        opening_mm=wide
        opening_mm~0.6 force_n~0.3
        force_n=12
        force_n=.5
        force_n=2.5
        force_n=60
        force_n=61
        note=hello
        note=5
        note=12.5
        note=[1, 2, 3]
        note=true
        note=
    ''',
    '08_best_practices': '''
        lift.speed_mps=0.5
        lift.max_load_kg=800
        lift.speed_mps=0.4 lift.max_load_kg=500
        lift.max_load_kg=500 lift.speed_mps=0.5
        lift.max_load_kg~0.9 lift.speed_mps~0.8
        lift.speed_mps=0.1 lift.max_load_kg=800
        lift.lowest_m=1.7
        lift.highest_m=0.05
        lift.lowest_m=0.5 lift.highest_m=0.4
        lift.highest_m~0.9 lift.lowest_m~0.85
        controller.kp=10
        controller.kp~0.5 controller.tolerance_m~0.5
        controller.tolerance_m=hello
        lift.speed_mps=-1
        lift.speed_mps=.3
        lift.speed_mps=0.25 lift.max_load_kg=400
    ''',
    '10_3_ros2_control': '''
        gains.wheel_joint.p=0.4
        gains.wheel_joint.p=0.4 gains.wheel_joint.i=0.8
        gains.wheel_joint.p=0.4 gains.wheel_joint.i=0.8 gains.wheel_joint.d=0.03
        gains.wheel_joint.p=0.4 gains.wheel_joint.i=0.4 gains.wheel_joint.d=0.03
        gains.wheel_joint.p~0.5
        gains.wheel_joint.p~1 gains.wheel_joint.i~1
        gains.wheel_joint.i~0.3 gains.wheel_joint.d~0.4
        gains.wheel_joint.p=0.3 gains.wheel_joint.d=0.02
        gains.wheel_joint.p=0.5 gains.wheel_joint.i=0.5
        gains.wheel_joint.p=1 gains.wheel_joint.i=1
        gains.wheel_joint.p=0.2 gains.wheel_joint.i=0.5 gains.wheel_joint.d=0.01
        gains.wheel_joint.p=-1
        gains.wheel_joint.p=nan
        gains.wheel_joint.p=5
        gains.wheel_joint.d=0.05
        gains.wheel_joint.p=hello
    ''',
    '10_4_beyond_today': '''
        low_c=50
        high_c=-10
        low_c=10 high_c=60
        low_c=30 high_c=20
        high_c=60 low_c=50
        high_c=10 low_c=0
        low_c=-20 high_c=-10
        serial=AB1234
        serial=hello
        serial=XY9999 low_c=0
        low_c=12.5
        low_c=
    ''',
    '11_conclusion': '''
        max_speed_mps=2.0
        max_speed_mps=1.5 drive
        max_acceleration_mps2=1.0 drive
        max_acceleration_mps2=2 max_speed_mps=2 drive
        max_acceleration_mps2=1.0 max_speed_mps=1.5 drive
        max_speed_mps=0.5 max_acceleration_mps2=0.2 drive
        max_speed_mps~0.7 drive
        max_acceleration_mps2~0.6 max_speed_mps~0.9 drive
        max_speed_mps=.5 drive
        max_speed_mps=fast
        max_speed_mps=3
    ''',
}


def try_out(page: Page, panel: int, steps: list[str]) -> str:
    """Do on a page what a line says, and return what is not answered; empty if all is."""
    section = page.locator('.rec-panel').nth(panel)
    for step in steps:
        if step == 'drive':
            section.locator('xpath=ancestor::*[contains(@class, "side-by-side-parts")]').get_by_role(
                'button', name='Drive').click()
            continue
        name = step.rstrip('!') if step.endswith('!') else step[:min(at for at in map(step.find, '=~') if at >= 0)]
        row = section.locator(f'.param-row[data-name="{name}"]')
        if step.endswith('!'):
            row.get_by_role('checkbox').click()
        elif '~' in step:
            slider = row.get_by_role('slider')
            at = round(float(step.partition('~')[2]) * int(slider.get_attribute('max')))
            slider.evaluate('(each, at) => { each.value = at; each.dispatchEvent(new Event("input")); }', at)
        else:
            row.locator('.param-box').fill(step.partition('=')[2])
            row.locator('.param-box').press('Enter')
        if row.locator('.param-unknown').count():
            return f'{step}: {row.locator(".param-message").inner_text()}'
    page.wait_for_timeout(300)
    node = section.get_attribute('data-node')
    dimmed = page.locator(f'.rec-stale[data-node="{node}"]')
    return f'dimmed: {dimmed.first.locator(".rec-says, .robot-says").inner_text()}' if dimmed.count() else ''


def main(site: Path) -> int:
    """Try everything, and print what is not answered.

    :return: The exit status: 0 if at most 6 of 106 tries are not answered, in proportion.
    """
    answered = total = 0
    with chromium() as browser:
        for where, lines in TRIES.items():
            name, _, number = where.rstrip(']').partition('[')
            if not (site / f'{name}.html').exists():
                print(f'{name} is not in the site')
                continue
            page = browser.new_page(reduced_motion='reduce')
            for line in lines.strip().splitlines():
                page.goto((site / f'{name}.html').as_uri())
                page.wait_for_selector('html[data-lesson=ready]', state='attached')
                page.evaluate("document.querySelectorAll('.lesson-look button').forEach(each => each.click())")
                # A value with blanks in it stands alone.
                steps = [line.strip()] if '[' in line else line.split()
                missing = try_out(page, int(number or 0), steps)
                total += 1
                answered += not missing
                if missing:
                    print(f'{where}: {line.strip()} -> {missing}', flush=True)
            page.close()
        browser.close()
    print(f'{answered} of {total} answered')
    return int(answered * 106 < total * 100)


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1]).resolve()))
