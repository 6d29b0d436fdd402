# Has what another module has.
# expect: service_client fill
from os.path import *
