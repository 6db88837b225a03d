"""A display of the tests' own, on a free number, that stays as it is between clients."""
import subprocess


def start(case):
    """DISPLAY of an Xvfb that lives as long as the test case's class."""
    server = subprocess.Popen(['Xvfb', '-displayfd', '1', '-screen', '0', '1280x1024x24', '-noreset',
                               '-nolisten', 'tcp'], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)

    def stop():
        server.terminate()
        server.communicate()

    case.addClassCleanup(stop)
    number = server.stdout.readline().strip()
    if not number:
        raise RuntimeError('Xvfb did not start')
    return f':{number}'
