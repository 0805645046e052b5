"""Wrong answers that people give to the exercises of chapter 4."""

WRONG = {
    '4a': [
        ([("self.declare_parameter('max_speed_rpm', 100)", "self.declare_parameter('max_speed_rpm', 100)\n"
           "        self.copy = self.get_parameter('max_speed_rpm').value"),
          ("self.get_parameter('max_speed_rpm').value)", 'self.copy)')], 2, 'a copy that it made in its constructor'),
        ([("self.get_parameter('max_speed_rpm').value)", "self.get_parameter('max_speed_rpm'))")], 0,
         "'<' not supported between instances of 'Parameter' and 'int'"),
        ([("self.get_parameter('max_speed_rpm').value)", '100)')], 1, 'the default in the source'),
        ([('min(', 'max(')], 0, '`500` and `100`'),
    ],
    '4b': [
        ([("'photo.value': 100", "'photo.value': 150")], 4, 'the photograph is older'),
        ([('.value": 150', '.value": 100')], 4, 'A new photograph'),
        ([('12.0', 'None')], 4, 'so the fallback is used'),
        ([('False', 'True')], 4, 'declares nothing'),
        ([('120', '150')], 4, 'a parameter lives in one node'),
    ],
}
