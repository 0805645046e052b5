"""JupyterHub's settings for a class on one machine: see README.md here, and `make hub`."""

import shutil
import sys
from pathlib import Path

c = get_config()  # noqa: F821 (JupyterHub reads this file, and brings it along)

# Who may sign in: everyone with an account on this machine, with its password (PAM).
c.JupyterHub.authenticator_class = 'pam'
c.PAMAuthenticator.allow_all = True
# Their JupyterLab, under their own account, on their own copies of the chapters.
c.Spawner.cmd = [sys.executable, str(Path(__file__).with_name('learner.py'))]
c.Spawner.default_url = '/lab/tree/index.md'
# At the beginning of a lesson the whole class starts at once, on a machine that may be small.
c.Spawner.start_timeout = c.Spawner.http_timeout = 300
# What JupyterHub remembers, for its own account only, also after a `chmod -R` that opened the course to the class.
state = Path(__file__).parents[2] / 'build' / 'jupyterhub_state'
state.mkdir(parents=True, exist_ok=True)
for path in (state, *state.iterdir()):
    path.chmod(path.stat().st_mode & 0o700)
c.JupyterHub.db_url = f'sqlite:///{state / "jupyterhub.sqlite"}'
c.JupyterHub.cookie_secret_file = str(state / 'cookie_secret')
c.ConfigurableHTTPProxy.pid_file = str(state / 'proxy.pid')
# The course needs no network, and each ROS domain stays on this machine.
c.JupyterHub.bind_url = 'http://127.0.0.1:8000'
# JupyterHub's usual proxy is a program of Node.js. Its port to Python will do, but it passes no sub-protocol of a
# WebSocket on, so a notebook connects at its second attempt.
c.ConfigurableHTTPProxy.command = [shutil.which('configurable-http-proxy')
                                   or str(Path(sys.executable).with_name('configurable-http-proxy'))]
