"""Wrong answers that people give to the exercises of chapter 2."""

WRONG = {
    '2a': [
        ([("['resource/lift']", "['lift']")], 0, "can't copy 'lift'"),
        ([("        ('share/ament_index/resource_index/packages', ['resource/lift']),\n", '')], 3,
         'what is installed in `share` is `share/lift/package.xml`'),
        ([("'lift_node = ", "'lift = ")], 3, 'No executable found'),
        ([('lift.lift_node:main', 'lift:main')], 4, "has no attribute 'main'"),
        ([("'0.0.0',", "'0.0.0'")], 0, 'SyntaxError'),
        ([('\nsetup(', '\ndict(')], 0, 'does it call `setup(...)`?'),
    ],
    '2b': [
        ([("(prefix / 'share/ament_index/resource_index/packages' / package).exists()", 'True')], 2,
         'Without the marker, ROS does not know of the package'),
        ([("'share/ament_index/resource_index/packages' / package", "'share' / package")], 1,
         "Package 'lift' not found"),
        ([("path if path.exists() else 'No executable found'", 'path')], 2, '`first/lib/lift/lift_node`'),
        ([("            return path if path.exists() else 'No executable found'",
           '            if path.exists():\n                return path')], 2, 'looks no further'),
        ([('in prefixes', 'in reversed(prefixes)')], 3, 'hides the other'),
    ],
}
