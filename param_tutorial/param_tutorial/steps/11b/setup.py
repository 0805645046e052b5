from setuptools import find_packages, setup

package_name = 'my_robot'

setup(
    name=package_name,
    version='1.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/config', ['config/my_robot.yaml', 'config/gripper.yaml']),
        ('share/' + package_name + '/launch',
            ['launch/my_robot_launch.py', 'launch/two_robots_launch.py']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='you',
    maintainer_email='you@example.org',
    description='A robot that stops in front of a wall, and whose parameters say how.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'console_scripts': [
            'driver_node = my_robot.driver_node:main',
            'tuner_node = my_robot.tuner_node:main',
            'gripper_node = my_robot.gripper_node:main'
        ],
    },
)
