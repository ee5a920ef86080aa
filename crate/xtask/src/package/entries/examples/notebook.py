# A cell of a Jupyter notebook. The script comes from a network that serves npm packages, and its hash is checked.
from IPython.display import HTML

HTML("""
<script src="{{cdn frond-view.js}}"
  integrity="{{sha384 frond-view.js}}" crossorigin="anonymous"></script>
<frond-view a="dragon-3" b="gasket" t="0.4" controls loop verdict style="max-width: 40rem"></frond-view>
""")
