# gnuplot sdof-stop-near-work-precision.gp makes sdof-stop-near-work-precision.svg and sdof-stop-near-work-precision.pdf of sdof-stop-near-work-precision.dat
data = 'sdof-stop-near-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-near-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [1.38e-05:3.34e-01]
set yrange [3.76e-13:2.83e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0402 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.358370e-04,1.127771e-12 to graph 1.05,0.0402 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1022 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 9.268500e-05,1.127771e-12 to graph 1.05,0.1022 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1848 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.073045e-02,5.887689e-11 to graph 1.05,0.1848 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.2560 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 4.308860e-04,4.162334e-04 to graph 1.05,0.2560 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3180 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.085120e-03,1.941525e-03 to graph 1.05,0.3180 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.3800 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 3.399258e-02,1.208362e-02 to graph 1.05,0.3800 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.4420 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.684782e-02,1.397000e-02 to graph 1.05,0.4420 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.5040 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.389282e-03,1.397000e-02 to graph 1.05,0.5040 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.5660 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 3.163702e-02,1.669519e-02 to graph 1.05,0.5660 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.6280 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.627844e-03,1.713847e-02 to graph 1.05,0.6280 nohead lc rgb '#D55E00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.6900 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 7.017572e-03,2.408108e-02 to graph 1.05,0.6900 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 7.261424e-03,2.857779e-02 to graph 1.05,0.7520 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.917739e-03,3.627559e-02 to graph 1.05,0.8140 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.112663e-01,4.431281e-02 to graph 1.05,0.8760 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.9380 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 5.209415e-03,6.341775e-02 to graph 1.05,0.9380 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,1.0000 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 4.834311e-03,6.341775e-02 to graph 1.05,1.0000 nohead lc rgb '#CC79A7' lw 0.5 back
set label '10 error bars' at graph 0.99, first 1.127771e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '40' at 5.209415e-03,6.341775e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.576888e-03,3.195962e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.570124e-03,1.604478e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 1.103408e-03,4.315618e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 2.684782e-02,1.397000e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 9.611485e-04,9.440482e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 3.040815e-03,4.782827e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 7.017572e-03,2.408108e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 6.841730e-03,1.208362e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 7.322140e-03,4.782827e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '5' at 1.692100e-04,6.753077e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 1.737080e-04,2.517532e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 1.914430e-04,9.166612e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 2.179420e-04,3.293174e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 2.797390e-04,1.173744e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 4.308860e-04,4.162334e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 2.374550e-03,6.246003e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 3.502058e-03,1.620222e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 6.992485e-03,7.800637e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 1.073045e-02,5.887689e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 1.282830e-04,1.127771e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 4.132800e-05,1.127771e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 9.268500e-05,1.127771e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1' at 1.112663e-01,4.431281e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40, 1e3' at 6.707910e-04,7.456912e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40, 1e5' at 2.534900e-04,4.315618e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160, 1e5' at 2.389282e-03,1.397000e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '2048' at 6.173290e-04,7.759946e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 3.085120e-03,1.941525e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 2.459998e-03,6.618074e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 6.380448e-03,3.328667e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 3.740280e-04,5.686529e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 7 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 15 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 17 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 18 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 19 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 20 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 21 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 22 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 23 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 24 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 25 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 26 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 27 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 28 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 29 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 30 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 31 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  1.127771e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
