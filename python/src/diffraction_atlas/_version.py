"""Version of the package: that of the workspace it comes from."""

VERSION = "0.1.0"
