from setuptools import setup

setup(
    name="rover_nodes",
    version="1.0.0",
    packages=["rover_nodes"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/rover_nodes"]),
        ("share/rover_nodes", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    entry_points={"console_scripts": ["keeper = rover_nodes.keeper:main"]},
)
