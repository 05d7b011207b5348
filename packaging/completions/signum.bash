# Completion of signum for bash; written by packaging/manual.py from the tool's help.
_signum() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} options='' words=''
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W 'triangulate voronoi compare sign generate validate study simulate torture --help --version' -- "$word")
        return
    fi
    case $command in
        triangulate) options='--help --columns --decimal --skip-lines --skip-missing --radius --metric --weight-is --seed --threads --quiet --dimension --read-as --method --order --arithmetic --memory --resume --output --format --clip --vertices --stats --check' ;;
        voronoi) options='--help --columns --decimal --skip-lines --skip-missing --radius --metric --weight-is --seed --threads --quiet --dimension --read-as --clip --tolerance --carry --merge --output --format' ;;
        compare) options='--help --columns --decimal --skip-lines --skip-missing --radius --metric --weight-is --seed --threads --quiet --dimension --read-as --arithmetic --against --seconds --json --output --format' ;;
        sign) options='--help --dimension --sphere --metric --weight-is --json --explain' ;;
        generate) options='--help --dimension -n --radius --perturb --seed --output --format' ;;
        validate) options='--help --columns --decimal --skip-lines --skip-missing --radius --read-as --finite --from-one --weight-is --output --format --threads --quiet' ;;
        study) options='--help --motion --dimension --output --quick --metric --sites --seconds --fresh --no-report --quiet' ;;
        simulate) options='--help --set --until --events --box --periodic --gravity --restitution --wall-restitution --structure --arithmetic --output --format --every --show --closest --save --resume --explain --stats --quiet' ;;
        torture) options='--help --orient2d --incircle --orient3d --insphere --init --returns --seconds --seed --sites --output --format --json --quiet' ;;
    esac
    [ "$COMP_CWORD" -eq 2 ] && [[ $word != -* ]] && before=
    case $command:$before in
        triangulate:--metric) words='power euclidean manhattan supremum' ;;
        triangulate:--weight-is) words='radius weight' ;;
        triangulate:--dimension) words='2 3' ;;
        triangulate:--read-as) words='text xyz cif gro pdb pqr off ply npy f64 node' ;;
        triangulate:--arithmetic) words='exact interval sum multiprecision naive single' ;;
        voronoi:--metric) words='power euclidean manhattan supremum' ;;
        voronoi:--weight-is) words='radius weight' ;;
        voronoi:--dimension) words='2 3' ;;
        voronoi:--read-as) words='text xyz cif gro pdb pqr off ply npy f64 node' ;;
        compare:--metric) words='power euclidean manhattan supremum' ;;
        compare:--weight-is) words='radius weight' ;;
        compare:--dimension) words='2 3' ;;
        compare:--read-as) words='text xyz cif gro pdb pqr off ply npy f64 node' ;;
        sign:) words='ccw in_circle in_sphere' ;;
        sign:--dimension) words='2 3' ;;
        sign:--metric) words='power euclidean manhattan supremum' ;;
        sign:--weight-is) words='radius weight' ;;
        generate:) words='random circle square grid lattice rings offset tangent hard sphere cube' ;;
        generate:--dimension) words='2 3' ;;
        validate:--read-as) words='text xyz cif gro pdb pqr off ply npy f64 node' ;;
        validate:--weight-is) words='radius weight' ;;
        study:--dimension) words='2 3' ;;
    esac
    if [ -n "$words" ]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    elif [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    fi
}
complete -o default -F _signum signum
