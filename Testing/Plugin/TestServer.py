# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pvpython TestServer.py <plugin> <Data> <command of pvserver...>: the filters on a server."""

import os
import socket
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview import simple

from PluginChecks import check_heart, check_sphere, load_plugin


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def start_server(command, port):
    """pvpython is an MPI process of its own; its server must not take itself for a part of it."""
    mpi = ("OMPI_", "PMIX_", "ORTE_", "OPAL_")
    environment = {k: v for k, v in os.environ.items() if not k.startswith(mpi)}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    server = subprocess.Popen(command + [f"--server-port={port}"], env=environment,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    for line in server.stdout:
        print("server:", line, end="")
        if "Accepting connection" in line:
            return server
    raise RuntimeError("the server did not start")


def main(plugin, data, *command):
    port = free_port()
    server = start_server(list(command), port)
    try:
        simple.Connect("127.0.0.1", port)
        load_plugin(plugin, remote=True)
        load_plugin(plugin, remote=False)
        check_sphere()
        check_heart(data)
    finally:
        # The server itself would end only with this process.
        server.kill()
    print("server: all checks passed")


main(*sys.argv[1:])
