"""The report as one HTML page: the document of what is known, and the page that shows it."""
