"""Component models in the formats that people and programs read: one small writer each."""
