#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speaks TLS on 127.0.0.1 and passes everything on to a port there that does not.

    tls_front.py CERTIFICATE KEY PORT

Prints its own port, then serves until it is ended.
"""
import socket
import ssl
import sys
import threading


def copy(source, target):
    try:
        while data := source.recv(65536):
            target.sendall(data)
        target.shutdown(socket.SHUT_WR)
    except OSError:
        pass  # one of the two has left


def serve(client, context, port):
    try:
        with context.wrap_socket(client, server_side=True) as inside:
            with socket.create_connection(("127.0.0.1", port)) as outside:
                threading.Thread(target=copy, args=(inside, outside), daemon=True).start()
                copy(outside, inside)
    except OSError:
        pass  # the client does not trust the certificate


def main():
    certificate, key, port = sys.argv[1:]
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(certificate, key)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        print(listener.getsockname()[1], flush=True)
        while True:
            client, _ = listener.accept()
            threading.Thread(target=serve, args=(client, context, int(port)), daemon=True).start()


main()
