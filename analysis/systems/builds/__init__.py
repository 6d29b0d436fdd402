"""What the builds of packages come to, and where they are wrong, as rows of `rules/schema/build.dl`."""
