from setuptools import setup

package_name = 'warehouse_nodes'

setup(
    name=package_name,
    version='0.2.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    entry_points={
        'console_scripts': [
            'base_driver = warehouse_nodes.base_driver:main',
            f'shelf_carrier = {package_name}.shelf_carrier:main',
        ],
    },
)
