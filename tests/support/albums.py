"""The pictures and films that a panel's recording holds, packed."""

import base64
import json
import zlib


def unpack(album):
    """Return the pictures of an album by their keys, as the page's script does."""
    content = json.loads(zlib.decompress(base64.b64decode(album)))

    def whole(each):
        if isinstance(each, list):
            return [whole(part) for part in each]
        if isinstance(each, dict):
            if '$' in each:
                return ''.join(content['parts'][number] for number in each['$'])
            return {name: whole(part) for name, part in each.items()}
        return each
    return {name: whole(each) for name, each in content['pictures'].items()}
