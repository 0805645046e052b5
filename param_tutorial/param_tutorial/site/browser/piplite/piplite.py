"""The worker of the kernel writes its settings here."""
